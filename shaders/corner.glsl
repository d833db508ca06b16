// Which of an item's three vertices this is: 0, 1 or 2. There is no integer division that several vertices share.
int corner_of_three() {
  int corner = gl_VertexID - 3 * int(float(gl_VertexID) * 0.3333333333);
  return corner < 0 ? corner + 3 : corner > 2 ? corner - 3 : corner;
}

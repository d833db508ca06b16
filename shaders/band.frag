// The band alone, where the surface that bears it is not shown.
in vec3 v_position;
out vec4 f_colour;

void main() {
  f_colour = band(v_position);
  if (f_colour.a <= 0.0) {
    discard;
  }
}

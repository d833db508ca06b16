layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_colour;
out vec3 v_position;
out vec3 v_normal;
flat out vec4 v_colour;

void main() {
  gl_Position = project(a_position, 0.0);
  v_position = a_position;
  v_normal = a_normal;
  v_colour = a_colour;
}

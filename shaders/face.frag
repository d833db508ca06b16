in vec3 v_position;
in vec3 v_normal;
flat in vec4 v_colour;
out vec4 f_colour;

void main() {
  vec4 over = band(v_position);
  f_colour = vec4(mix(lit(v_colour.rgb, v_position, v_normal), over.rgb, over.a), v_colour.a);
}

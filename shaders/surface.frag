in vec3 v_position;
in vec3 v_normal;
in float v_time;
in float v_timed;
out vec4 f_colour;

void main() {
  vec3 colour = lit(ground_colour(v_time, v_timed), v_position, v_normal);
  vec4 over = band(v_position);
  f_colour = vec4(mix(colour, over.rgb, over.a), 1.0);
}

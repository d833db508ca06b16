// A little darker or lighter than the ground it lies on, or of the ground's colour where that is not shown.
in vec3 v_position;
in vec3 v_normal;
in float v_time;
in float v_timed;
uniform float u_alone;  // 1: no surface under it
uniform float u_alpha;
uniform float u_alpha_behind;  // on the side that looks away
out vec4 f_colour;

void main() {
  vec3 to_eye = to_eye_from(v_position);
  vec3 n = normalize(v_normal);
  float facing = dot(n, to_eye);
  vec3 colour = shaded(ground_colour(v_time, v_timed), facing < 0.0 ? -n : n, to_eye);
  float grey = dot(colour, vec3(0.30, 0.59, 0.11));
  vec3 line = mix(mix(colour, vec3(1.0), 0.40), colour * 0.30, smoothstep(0.16, 0.28, grey));
  line = mix(line, colour, u_alone);
  // Seen from the side lines crowd together: fade them there.
  float alpha = facing > 0.0 ? mix(0.25 * u_alpha, u_alpha, smoothstep(0.0, 0.55, facing)) : u_alpha_behind;
  f_colour = vec4(line, alpha);
}

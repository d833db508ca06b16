// A ribbon as the tube that it stands for. What lies deep in the fabric is darker, on either side of it.
in float v_across;
in float v_turn;
in vec3 v_side;
in vec3 v_up;
in vec3 v_outward;
in float v_depth;
flat in vec3 v_colour;
uniform float u_plies;  // 1: grooves between three plies
out vec4 f_colour;

void main() {
  float a = clamp(v_across, -1.0, 1.0);
  vec3 n = normalize(v_side * a + v_up * sqrt(1.0 - a * a));
  // Seen from behind, the fabric's inner side is the one with light.
  float seen = 2.0 * smoothstep(-0.3, 0.3, dot(v_up, v_outward)) - 1.0;
  float open = 0.45 + 0.55 * smoothstep(-0.6, 0.9, seen * dot(n, v_outward));
  open *= clamp(0.86 + 1.1 * seen * v_depth, 0.45, 1.08);
  vec3 colour = v_colour * open;
  if (u_plies > 0.5) {
    vec3 along = cross(v_up, v_side);
    float angle = atan(dot(n, cross(along, v_outward)), dot(n, v_outward));
    float phase = 2.0 * fract(0.4774648 * angle + v_turn) - 1.0;
    float groove = phase * phase;
    colour *= 1.0 - 0.34 * groove * groove * groove;
  }
  f_colour = vec4(shaded(colour, n, v_up), 1.0);
}

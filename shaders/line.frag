in vec2 v_place;
flat in float v_length;
flat in float v_half;
flat in vec4 v_colour;
uniform float u_alpha;
uniform float u_round;  // 1: round ends, which join; 0: none, so that faint lines show no knots
out vec4 f_colour;

void main() {
  float beyond = v_place.x - clamp(v_place.x, 0.0, v_length);
  if (u_round < 0.5 && abs(beyond) > 0.0) {
    discard;
  }
  float cover = clamp(v_half + 0.5 - length(vec2(beyond, v_place.y)), 0.0, 1.0);
  f_colour = vec4(v_colour.rgb, v_colour.a * cover * u_alpha);
}

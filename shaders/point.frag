in vec2 v_place;
flat in float v_radius;
flat in float v_rim;
flat in vec4 v_colour;
flat in vec3 v_rim_colour;
uniform float u_alpha;
out vec4 f_colour;

void main() {
  float d = length(v_place);
  float disc = clamp(v_radius + 0.5 - d, 0.0, 1.0);
  float whole = clamp(v_radius + v_rim + 0.5 - d, 0.0, 1.0);
  f_colour = vec4(mix(v_rim_colour, v_colour.rgb, disc), v_colour.a * u_alpha * whole * mix(0.8, 1.0, disc));
}

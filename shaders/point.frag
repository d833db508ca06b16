noperspective in vec2 v_place;
flat in float v_radius;
flat in vec4 v_colour;
uniform float u_alpha;
uniform float u_scale;
out vec4 f_colour;

void main() {
  float d = length(v_place);
  float rim = min(1.1 * u_scale, 0.5 * v_radius + 0.4);
  float disc = clamp(v_radius + 0.5 - d, 0.0, 1.0);
  float whole = clamp(v_radius + rim + 0.5 - d, 0.0, 1.0);
  vec3 dark = v_colour.rgb * 0.16;
  f_colour = vec4(mix(dark, v_colour.rgb, disc), v_colour.a * u_alpha * whole * mix(0.8, 1.0, disc));
}

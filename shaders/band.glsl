// For fragment shaders: the anchor's reach, a ring between two distances from its place.
uniform vec4 u_band_colour;  // alpha 0: no band
uniform vec3 u_band_centre;
uniform vec3 u_band_reach;   // inner, middle, outer; middle 0: no line there
uniform float u_scale;       // pixels of this screen in one pixel of a plain one

// How much a line of `half_width` pixels around the distance `at` covers a place `d` away.
float ring(float d, float at, float pixel, float half_width) {
  return clamp(half_width + 0.5 - abs(d - at) / pixel, 0.0, 1.0);
}

vec4 band(vec3 world) {
  float d = distance(world, u_band_centre);
  float pixel = max(fwidth(d), 1e-9);
  float inside = clamp((d - u_band_reach.x) / pixel + 0.5, 0.0, 1.0) *
                 clamp((u_band_reach.z - d) / pixel + 0.5, 0.0, 1.0);
  float outline = ring(d, u_band_reach.z, pixel, 0.9 * u_scale);
  float casing = ring(d, u_band_reach.z, pixel, 2.0 * u_scale);
  if (u_band_reach.x > 0.0) {
    outline = max(outline, ring(d, u_band_reach.x, pixel, 0.9 * u_scale));
    casing = max(casing, ring(d, u_band_reach.x, pixel, 2.0 * u_scale));
  }
  if (u_band_reach.y > 0.0) {
    outline = max(outline, 0.85 * ring(d, u_band_reach.y, pixel, 0.5 * u_scale));
    casing = max(casing, 0.7 * ring(d, u_band_reach.y, pixel, 1.4 * u_scale));
  }
  // A dark casing keeps the outline readable on a ground of its own colour.
  vec3 colour = mix(u_band_colour.rgb, 0.12 * u_band_colour.rgb, casing * (1.0 - outline));
  float alpha = max(0.36 * inside, max(0.55 * casing, outline));
  return vec4(colour, u_band_colour.a * alpha);
}

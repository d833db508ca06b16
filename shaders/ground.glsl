// For fragment shaders: the colour of the ground, from the calm one to the ramp over the time of a place.
uniform vec3 u_ground;
uniform vec3 u_low;
uniform vec3 u_middle;
uniform vec3 u_high;

vec3 ground_colour(float time, float timed) {
  float t = clamp(time, 0.0, 1.0);
  vec3 ramp = t < 0.5 ? mix(u_low, u_middle, 2.0 * t) : mix(u_middle, u_high, 2.0 * t - 1.0);
  return mix(u_ground, ramp, smoothstep(0.0, 1.0, timed));
}

// For fragment shaders: soft light that comes along with the camera. No highlights: colours have a meaning.
uniform mat4 u_view;
uniform vec3 u_eye;
uniform float u_parallel;  // 1: the view has no vanishing point

float wrapped(float cosine, float wrap) { return clamp((cosine + wrap) / (1.0 + wrap), 0.0, 1.0); }

vec3 to_eye_from(vec3 world) {
  vec3 backward = vec3(u_view[0][2], u_view[1][2], u_view[2][2]);
  return u_parallel > 0.5 ? backward : normalize(u_eye - world);
}

// `n` looks to the eye's side.
vec3 shaded(vec3 colour, vec3 n, vec3 to_eye) {
  vec3 seen = mat3(u_view) * n;
  float key = wrapped(dot(seen, normalize(vec3(-0.40, 0.45, 0.80))), 0.42);
  float fill = wrapped(dot(seen, normalize(vec3(0.70, -0.45, 0.50))), 0.50);
  float light = 0.46 + 0.44 * key + 0.20 * fill;
  float turn = 1.0 - clamp(dot(n, to_eye), 0.0, 1.0);
  light *= 1.0 - 0.22 * turn * turn * turn;
  // Shadows a little cooler than the light: form reads without greying the colour.
  vec3 tint = mix(vec3(0.95, 0.975, 1.05), vec3(1.01, 1.0, 0.985), clamp(key, 0.0, 1.0));
  return colour * light * tint;
}

// For triangles; what one sees of their inner side is darker.
vec3 lit(vec3 colour, vec3 world, vec3 normal) {
  vec3 to_eye = to_eye_from(world);
  vec3 flat_normal = cross(dFdx(world), dFdy(world));
  flat_normal *= dot(flat_normal, to_eye) < 0.0 ? -1.0 : 1.0;
  vec3 n = normalize(normal);
  if (dot(n, flat_normal) >= 0.0) {
    return shaded(colour, n, to_eye);
  }
  vec3 result = shaded(colour, -n, to_eye);
  return 0.55 * mix(result, vec3(dot(result, vec3(0.30, 0.59, 0.11))), 0.35);
}

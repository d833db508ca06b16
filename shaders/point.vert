// Three vertices are one disc that faces the eye: a triangle around it. Setting up a triangle costs more than the
// pixels of it that stay empty.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec4 a_colour;
layout(location = 2) in float a_diameter;
uniform float u_scale;
uniform float u_toward;
out vec2 v_place;  // pixels from the middle
flat out float v_radius;
flat out float v_rim;
flat out vec4 v_colour;
flat out vec3 v_rim_colour;

// Dark, and light round dark grey discs, or many beside each other would be one black band.
vec3 rim_colour_of(vec3 disc) {
  float spread = max(max(disc.r, disc.g), disc.b) - min(min(disc.r, disc.g), disc.b);
  float light = dot(disc, vec3(0.299, 0.587, 0.114));
  return spread < 0.12 && light < 0.45 ? vec3(0.9) : disc * 0.16;
}

void main() {
  int number = corner_of_three();
  vec2 corner = number == 2 ? vec2(0.0, 2.0) : vec2(float(number) * 2.0 - 1.0, -0.5773503) * vec2(1.7320508);
  v_radius = 0.5 * a_diameter * u_scale;
  vec3 eye = to_eye(a_position);
  v_colour = vec4(a_colour.rgb, a_colour.a * paled(eye.z));
  v_rim_colour = rim_colour_of(a_colour.rgb);
  v_rim = min(1.1 * u_scale, 0.5 * v_radius + 0.4);
  float room = v_radius + v_rim + 0.5;
  v_place = corner * room;
  float clip_w = clip_w_of(eye);
  // As much nearer as it is wide, or a slanting surface would cut it.
  gl_Position = project_eye(eye, u_toward + v_radius * world_per_pixel(max(clip_w, 0.0)));
  gl_Position.xy += v_place / (0.5 * u_viewport) * gl_Position.w;
}

// Three vertices are one line: on the screen a rectangle around it, with room for round ends and a soft edge, and
// around that a triangle with a right angle at the farther end. Setting up a triangle costs more than the pixels of
// it that stay empty.
layout(location = 0) in vec3 a_from;
layout(location = 1) in vec3 a_to;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_width;
uniform float u_scale;
uniform float u_toward;
uniform float u_chord;    // a chord of length L runs up to u_chord * L * L below the surface,
uniform float u_deepest;  // or this, for lines that are no chords at all
out vec2 v_place;  // pixels along and across
flat out float v_length;
flat out float v_half;
flat out vec4 v_colour;

const float nearest = 1e-4;

void main() {
  int corner = corner_of_three();
  float span = distance(a_from, a_to);
  float width = a_width * u_scale;
  vec3 eye_from = to_eye(a_from);
  vec3 eye_to = to_eye(a_to);
  vec3 middle = 0.5 * (eye_from + eye_to);
  float middle_w = clip_w_of(middle);
  float half_world = 0.5 * width * world_per_pixel(max(middle_w, 0.0));
  float toward = u_toward + min(u_chord * span * span, u_deepest) + half_world;
  vec4 a = project_eye(eye_from, toward);
  vec4 b = project_eye(eye_to, toward);
  v_half = 0.5 * max(width, 1.0);
  float alpha = a_colour.a * min(width, 1.0) * paled(middle.z);
  v_colour = vec4(a_colour.rgb, alpha);
  v_length = 0.0;
  v_place = vec2(0.0);
  if (a.w < nearest && b.w < nearest) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (a.w < nearest) {
    a = mix(b, a, (b.w - nearest) / (b.w - a.w));
  }
  if (b.w < nearest) {
    b = mix(a, b, (a.w - nearest) / (a.w - b.w));
  }
  vec3 start = a.xyz / a.w;
  vec3 end = b.xyz / b.w;
  if (start.z < end.z) {
    vec3 nearer = start;
    start = end;
    end = nearer;
  }
  vec2 way = (end.xy - start.xy) * 0.5 * u_viewport;
  v_length = length(way);
  vec2 along = v_length > 1e-4 ? way / v_length : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float room = v_half + 0.5;
  float whole = v_length + 2.0 * room;
  v_place = vec2(corner == 1 ? 2.0 * whole - room : -room, corner == 2 ? 3.0 * room : -room);
  vec2 place = start.xy + (along * v_place.x + across * v_place.y) / (0.5 * u_viewport);
  // As deep as the line's ends where the rectangle ends.
  gl_Position = vec4(place, corner == 1 ? 2.0 * end.z - start.z : start.z, 1.0);
}

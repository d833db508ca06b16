// For vertex shaders: from the world to the screen.
uniform mat4 u_view;
uniform mat4 u_projection;
uniform vec2 u_viewport;  // pixels

bool perspective() { return u_projection[3][3] == 0.0; }

// World units that one pixel covers at a place whose clip.w is given.
float world_per_pixel(float clip_w) { return 2.0 * clip_w / (u_projection[1][1] * u_viewport.y); }

vec3 to_eye(vec3 world) { return (u_view * vec4(world, 1.0)).xyz; }

// Of a place as the eye sees it.
float clip_w_of(vec3 eye) { return u_projection[2][3] * eye.z + u_projection[3][3]; }

// Where a place, as the eye sees it, lands on the screen, with the depth that it would have `toward` units nearer.
vec4 project_eye(vec3 eye, float toward) {
  vec4 clip = u_projection * vec4(eye, 1.0);
  if (clip.w <= 0.0) {
    return clip;
  }
  if (perspective()) {
    toward = min(toward, 0.5 * clip.w);
  }
  float z = eye.z + toward;
  float depth = (u_projection[2][2] * z + u_projection[3][2]) / (u_projection[2][3] * z + u_projection[3][3]);
  if (clip.z >= -clip.w) {
    depth = clamp(depth, -0.99999, 0.99999);  // the shift itself never clips
  }
  return vec4(clip.xy, depth * clip.w, clip.w);
}

vec4 project(vec3 world, float toward) { return project_eye(to_eye(world), toward); }

// Where nothing hides what is behind, the far side pales: 1 at depth u_near and nearer, u_far_alpha at u_far.
uniform float u_near;
uniform float u_far;
uniform float u_far_alpha;
float paled(float eye_z) { return mix(1.0, u_far_alpha, smoothstep(u_near, u_far, -eye_z)); }

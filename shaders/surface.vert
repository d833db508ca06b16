layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in float a_time;
uniform vec3 u_eye;
uniform float u_push;    // away from the eye, so that knit faces, which cut corners, stay in front
uniform float u_toward;  // back toward the eye, for the wire on it
uniform int u_timed;     // vertices that have their time
out vec3 v_position;
out vec3 v_normal;
out float v_time;
out float v_timed;

void main() {
  float slope = abs(dot(normalize(a_normal), normalize(u_eye - a_position)));
  gl_Position = project(a_position, u_toward - u_push / max(slope, 0.25));
  v_position = a_position;
  v_normal = a_normal;
  v_time = a_time;
  v_timed = gl_VertexID < u_timed && a_time >= 0.0 ? 1.0 : 0.0;
}

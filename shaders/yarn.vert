// One vertex of a ribbon along a piece of yarn; which one, its number says. The ribbon is turned to the eye; of three
// vertices across the middle one is raised as far as a tube's nearest line.
uniform sampler2D u_points;  // control points, and the twist of the plies there, in turns
uniform sampler2D u_pieces;  // three texels a piece: first point, spans and colour; outwards at its begin and at its end
uniform int u_parts;
uniform int u_across;
uniform float u_radius;
uniform float u_width;  // of a stitch
uniform vec3 u_eye;
uniform float u_parallel;
out float v_across;  // -1 to 1
out float v_turn;
out vec3 v_side;
out vec3 v_up;       // across the yarn, to the eye
out vec3 v_outward;  // of the piece
out float v_depth;   // how far outwards of the fabric's middle, in stitch widths
flat out vec3 v_colour;

vec4 texel(sampler2D from, int at) { return texelFetch(from, ivec2(at & 2047, at >> 11), 0); }

void main() {
  int piece = gl_VertexID >> 7;
  int local = gl_VertexID & 127;
  int part = u_across == 2 ? local >> 1 : int((float(local) + 0.5) * 0.3333333333);
  int side = local - part * u_across;
  vec4 about = texel(u_pieces, 3 * piece);
  vec4 out_from = texel(u_pieces, 3 * piece + 1);
  vec4 out_to = texel(u_pieces, 3 * piece + 2);
  float share = float(part) / float(u_parts);
  float along = share * about.y;
  float whole = min(floor(along), about.y - 1.0);
  float x = along - whole;
  int at = int(about.x) + int(whole);
  vec4 p0 = texel(u_points, at - 1);
  vec4 p1 = texel(u_points, at);
  vec4 p2 = texel(u_points, at + 1);
  vec4 p3 = texel(u_points, at + 2);
  vec4 a = 3.0 * (p1 - p2) + p3 - p0;
  vec4 b = 2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3;
  vec4 c = p2 - p0;
  vec4 place = p1 + 0.5 * x * (c + x * (b + x * a));
  vec3 way = c.xyz + x * (2.0 * b.xyz + 3.0 * x * a.xyz);
  vec3 backward = vec3(u_view[0][2], u_view[1][2], u_view[2][2]);
  vec3 to_eye = u_parallel > 0.5 ? backward : normalize(u_eye - place.xyz);
  vec3 across = cross(way, to_eye);
  float across_length = length(across);
  across = across_length > 1e-12 ? across / across_length : normalize(cross(to_eye, vec3(0.34, 0.81, 0.48)));
  v_side = across;
  v_up = normalize(cross(across, way) + 1e-9 * to_eye);
  float sign_across = u_across == 2 ? 2.0 * float(side) - 1.0 : float(side) - 1.0;
  v_across = sign_across;
  v_turn = place.w;
  v_outward = mix(out_from.xyz, out_to.xyz, share);
  v_depth = (dot(place.xyz, v_outward) - mix(out_from.w, out_to.w, share)) / u_width;
  float raised = u_across == 3 && side == 1 ? u_radius : 0.0;
  gl_Position = project(place.xyz + u_radius * sign_across * across + raised * to_eye, 0.0);
  float red = floor(about.z / 65536.0);
  float green = floor((about.z - 65536.0 * red) / 256.0);
  v_colour = vec3(red, green, about.z - 65536.0 * red - 256.0 * green) / 255.0;
}

#include "app/render/yarn_drawer.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace app {

namespace {

constexpr std::size_t texels_a_line = 2048;
constexpr std::size_t texels_a_piece = 3;
// A stitch that looks away by more than this is behind those that do not: the cosine, with room for how thick fabric is.
constexpr float looks_away = -0.2F;
constexpr float reach = 1.6F;  // of a piece around its middle, in stitch widths

GlTexture texture_of_floats(std::vector<glm::vec4> texels) {
  const std::size_t lines = std::max<std::size_t>((texels.size() + texels_a_line - 1) / texels_a_line, 1);
  texels.resize(lines * texels_a_line, glm::vec4(0.0F));
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(texels_a_line), static_cast<GLsizei>(lines),
               0, GL_RGBA, GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

// A whole number below 2^24, which a float has exactly.
float packed(Colour colour) {
  return static_cast<float>((std::uint32_t{colour.r} << 16U) | (std::uint32_t{colour.g} << 8U) | colour.b);
}

std::size_t most_texels() {
  GLint lines = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &lines);
  return texels_a_line * static_cast<std::size_t>(std::max(lines, 1024));
}

bool fits(const YarnShape::Piece& piece, std::size_t points) {
  return piece.first + piece.spans + 2 <= points;
}

}  // namespace

YarnBuffers::YarnBuffers(const YarnShape& shape) {
  const std::size_t most = most_texels();
  std::vector<glm::vec4> points(
      shape.points.begin(),
      shape.points.begin() + static_cast<std::ptrdiff_t>(std::min(shape.points.size(), most)));
  std::vector<glm::vec4> texels;
  for (const YarnShape::Piece& piece : shape.pieces) {
    if (!fits(piece, points.size()) || texels.size() + texels_a_piece > most) break;
    texels.emplace_back(static_cast<float>(piece.first), static_cast<float>(piece.spans),
                        packed(piece.colour), 0.0F);
    for (const glm::vec3& out : {piece.from_out, piece.to_out})
      texels.emplace_back(out, glm::dot(out, piece.centre));
    extent_.add(piece.centre);
    ++pieces_;
  }
  points_ = texture_of_floats(std::move(points));
  pieces_texture_ = texture_of_floats(std::move(texels));
}

void YarnBuffers::bind() const {
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, pieces_texture_.id());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, points_.id());
}

double yarn_stitch_px(const Extent& extent, float width, const Sight& view, float viewport_height,
                      float scale) {
  const glm::vec4 centre = view.view * glm::vec4(extent.centre(), 1.0F);
  const float nearest = std::max(-centre.z - 0.29F * extent.diagonal(), -0.3F * centre.z);
  const float clip_w = view.projection[2][3] * -nearest + view.projection[3][3];
  return static_cast<double>(width * view.projection[1][1] * viewport_height /
                             (2.0F * std::max(clip_w, 1e-6F) * scale));
}

YarnPiecesSeen yarn_pieces_seen(const YarnShape& shape, std::size_t count, const Sight& view,
                                const Extent& extent) {
  const Frustum frustum(view.projection * view.view);
  const bool parallel = view.projection[3][3] != 0.0F;
  const glm::vec3 backward(view.view[0][2], view.view[1][2], view.view[2][2]);
  const bool outside = parallel || !(glm::all(glm::greaterThanEqual(view.eye, extent.low)) &&
                                     glm::all(glm::lessThanEqual(view.eye, extent.high)));
  const float radius = reach * shape.width;
  YarnPiecesSeen seen;
  for (std::uint32_t i = 0; i < std::min(count, shape.pieces.size()); ++i) {
    const YarnShape::Piece& piece = shape.pieces[i];
    const glm::vec3 to_eye = parallel ? backward : glm::normalize(view.eye - piece.centre);
    const bool behind = outside && glm::dot(to_eye, piece.from_out) < looks_away;
    if ((behind && shape.closed) || !frustum.touches(piece.centre, radius)) continue;
    (behind ? seen.behind : seen.facing).push_back(i);
  }
  return seen;
}

namespace {

// Two triangles for each of the `across` - 1 strips of each part.
void list_piece(std::uint32_t piece, const YarnDetail& detail, std::vector<std::uint32_t>& indices) {
  const auto across = static_cast<std::uint32_t>(detail.across);
  for (std::uint32_t part = 0; part < static_cast<std::uint32_t>(detail.parts); ++part) {
    for (std::uint32_t side = 0; side + 1 < across; ++side) {
      const std::uint32_t a = piece * vertices_a_piece + part * across + side, b = a + across;
      indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
}

}  // namespace

YarnDrawer::YarnDrawer() : array_(GlVertexArray::make()), indices_(GlBuffer::make()) {}

void YarnDrawer::list(const YarnBuffers& buffers, const std::shared_ptr<const YarnShape>& shape,
                      const Sight& view, const YarnDetail& detail) {
  const bool same = !listed_.owner_before(shape) && !shape.owner_before(listed_);
  if (same && listed_view_ == view && facing_.detail == detail) return;
  const YarnPiecesSeen seen = yarn_pieces_seen(*shape, buffers.pieces(), view, buffers.extent());
  std::vector<std::uint32_t> indices;
  const auto list_part = [&](const std::vector<std::uint32_t>& pieces, const YarnDetail& fine) {
    const std::size_t first = indices.size();
    for (const std::uint32_t piece : pieces) list_piece(piece, fine, indices);
    return Part{fine, first, indices.size() - first};
  };
  facing_ = list_part(seen.facing, detail);
  behind_ = list_part(seen.behind, yarn_detail_behind(detail));
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_DYNAMIC_DRAW);
  listed_ = shape;
  listed_view_ = view;
}

std::size_t YarnDrawer::draw_facing(const ShaderProgram& program, const YarnBuffers& buffers,
                                    const YarnShape& shape) {
  return draw(program, buffers, shape, facing_);
}

std::size_t YarnDrawer::draw_behind(const ShaderProgram& program, const YarnBuffers& buffers,
                                    const YarnShape& shape) {
  return draw(program, buffers, shape, behind_);
}

std::size_t YarnDrawer::draw(const ShaderProgram& program, const YarnBuffers& buffers, const YarnShape& shape,
                             const Part& part) {
  if (part.count == 0) return 0;
  glBindVertexArray(array_.id());
  buffers.bind();
  program.set("u_points", 0);
  program.set("u_pieces", 1);
  program.set("u_parts", part.detail.parts);
  program.set("u_across", part.detail.across);
  program.set("u_plies", part.detail.plies ? 1.0F : 0.0F);
  program.set("u_radius", shape.radius);
  program.set("u_width", shape.width);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                 at_offset(part.first * sizeof(std::uint32_t)));
  return part.count / 3;
}

}  // namespace app

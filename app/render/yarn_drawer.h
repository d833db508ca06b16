// Draws yarn [app/scene/yarn_shape.h]: each piece a ribbon that is turned to the eye and lit as a tube.
//
// The card has the control points in a texture of four floats a texel, and what pieces are in another, so that the vertex
// shader needs no attributes: a vertex's number says its piece and its place on it. Textures are read by texelFetch, which
// OpenGL 3.3 and WebGL 2 both have. What is listed each time the view turns are the triangles of those pieces that are seen:
// a piece outside the view, or one that looks away where the inner side is nowhere open, costs nothing.
// With a processor that draws, a frame costs about as much as its triangles; so the detail follows the size on the screen.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/render/batch.h"
#include "app/render/picture_texture.h"
#include "app/render/program.h"
#include "app/scene/scene.h"

namespace app {

class YarnBuffers {
 public:
  explicit YarnBuffers(const YarnShape& shape);
  void bind() const;  // to the texture units 0 and 1
  [[nodiscard]] const Extent& extent() const { return extent_; }
  [[nodiscard]] std::size_t pieces() const { return pieces_; }  // that fit into the textures

 private:
  GlTexture points_, pieces_texture_;
  Extent extent_;
  std::size_t pieces_ = 0;
};

// As many vertices as a piece has numbers for.
inline constexpr std::uint32_t vertices_a_piece = 128;
static_assert((yarn_detail(1e9).parts + 1) * 3 <= static_cast<int>(vertices_a_piece));

// How wide a stitch is on the screen where the piece is nearest, in pixels of a plain screen.
double yarn_stitch_px(const Extent& extent, float width, const Sight& view, float viewport_height,
                      float scale);

// The pieces to draw, by their numbers, of the first `count`.
struct YarnPiecesSeen {
  std::vector<std::uint32_t> facing, behind;  // that look to the eye, and away from it
};
YarnPiecesSeen yarn_pieces_seen(const YarnShape& shape, std::size_t count, const Sight& view,
                                const Extent& extent);

class YarnDrawer {
 public:
  YarnDrawer();
  // What both of the next are of; works only where something changed.
  void list(const YarnBuffers& buffers, const std::shared_ptr<const YarnShape>& shape, const Sight& view,
            const YarnDetail& detail);
  // With the program in use and its camera set; gives how many triangles. What looks away is drawn after all that hides it.
  std::size_t draw_facing(const ShaderProgram& program, const YarnBuffers& buffers, const YarnShape& shape);
  std::size_t draw_behind(const ShaderProgram& program, const YarnBuffers& buffers, const YarnShape& shape);

 private:
  // In the list of triangles.
  struct Part {
    YarnDetail detail;
    std::size_t first = 0, count = 0;
  };
  std::size_t draw(const ShaderProgram& program, const YarnBuffers& buffers, const YarnShape& shape,
                   const Part& part);

  GlVertexArray array_;
  GlBuffer indices_;
  // What the triangles listed are of.
  std::weak_ptr<const YarnShape> listed_;
  Sight listed_view_;
  Part facing_, behind_;
};

}  // namespace app

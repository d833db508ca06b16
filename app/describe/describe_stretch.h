// How fabric is stretched while it settles, or relaxes in the air: its edges in colours, and the way of each stitch from where it was placed.
//
// The stretch of an edge is its length over what it should be, h for a wale and w for a course; 1 is at ease. Colours go
// by its logarithm, so that half as long is as far from 1 as twice as long: blue too short, orange too long, and both
// drawn wider, so that nobody needs the colours to see where it is tight.
#pragma once

#include <optional>
#include <vector>

#include "app/scene/scene.h"
#include "app/scene/stretch_colour.h"
#include "app/session/session.h"

namespace app {

// What edges should measure, in mesh units.
struct StretchScale {
  double width = 1.0, height = 1.0;
  double full = full_stretch;
  friend bool operator==(const StretchScale&, const StretchScale&) = default;
};

// None: edges are plain, and faces bear their labels. While stitches settle, and afterwards where no faces are shown,
// because edges and faces cannot both speak.
std::optional<StretchScale> stretch_shown(const Session& session);
bool moves_shown(const Session& session);

// The same lines in the colours of their stretch, `length` being at ease and `full` where colours are.
void colour_by_stretch(const Theme& theme, double length, double full, std::vector<Line>& lines);
// Faces that say nothing.
void make_plain(const Theme& theme, FaceShape& shape);

// A thin line for each stitch that has moved, from where it was placed, or in the air from the mesh; of many only some (Scene::coarse).
void describe_moves(const Session& session, Scene& scene);

}  // namespace app

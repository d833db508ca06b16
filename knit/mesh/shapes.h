// Shapes that we make: surfaces of revolution about y with rings in order, for the examples, and others for
// tests.
//
// Every shape is closed, its triangles counter-clockwise seen from outside. Vertices come from the bottom up:
// the bottom pole, the rings, the top pole. A ring's vertices share y to the bit, its first lies exactly in
// direction -z (x is 0), and the rest follow counter-clockwise seen along +y, equally spaced; what mirrors,
// mirrors to the bit.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "knit/mesh/mesh.h"

namespace knit {

struct ProfilePoint {
  double radius = 0.0;
  double y = 0.0;
};

// Sine and cosine of num / den of a full turn, 0 <= num <= den: exact at the quarters, and mirror-exact
// between.
struct TurnPoint {
  double sine = 0.0;
  double cosine = 1.0;
};
TurnPoint turn_point(unsigned long num, unsigned long den);

// Revolves a profile from the bottom pole to the top pole; first and last radius must be 0, all others
// positive. With closing_copy, each ring ends with a copy of its first vertex that the ring's last faces use
// (a UV seam).
Mesh revolve(std::string name, std::span<const ProfilePoint> profile, unsigned segments, bool closing_copy);

// Radius 1; ring j at polar angle pi j / stacks from the bottom.
Mesh sphere(unsigned segments, unsigned stacks, bool closing_copy = false);

// These have rings about `spacing` apart along the profile, the same between all.
Mesh stretched_sphere(unsigned segments, double spacing);  // radius 0.8, height 3.2
Mesh egg(unsigned segments, double spacing);               // blunt end down, height 2.5
Mesh capsule(unsigned segments, double spacing);           // radius 0.7, height 2.6
Mesh cone(unsigned segments, double spacing);  // rounded tip up, on a domed base; height about 2.2
Mesh vase(unsigned segments, double spacing);  // belly, neck and a round lid; height 2.6

// Around y; the outermost circle has radius ring_radius + tube_radius. No poles: its level sets split.
Mesh torus(unsigned segments, unsigned tube_segments, double ring_radius, double tube_radius);

// Radius 1, 20 * 4^subdivisions triangles, no rings.
Mesh icosphere(unsigned subdivisions);

// Vertices and triangles with the shortest numbers that read back the same; the comment's lines come first.
void write_obj(std::ostream& out, const Mesh& mesh, std::string_view comment);

}  // namespace knit

// From curves of yarn to what a renderer draws of them [app/scene/yarn_shape.h], and the ground behind the loops.
//
// Stitches by number along the knitting path. Cost: points.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "app/scene/palette.h"
#include "app/scene/scene.h"
#include "app/scene/yarn_look.h"
#include "knit/fabric/fabric.h"
#include "knit/yarn/yarn.h"

namespace app {

// The yarn as thick as it should look, and eased as often.
knit::Yarn yarn_as_looked(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                          const knit::StitchSize& stitch, const YarnLook& look);

// Of each stitch, of length 1: the mean of the faces around it, by their areas. Bridges and what has no face have 0.
std::vector<glm::vec3> outwards(const knit::Fabric& fabric, std::span<const glm::dvec3> positions);

// Of each stitch, from 0: which whole round of its tube it is of. Short rows are of the round that is worked over them, bridges
// of the round before.
std::vector<std::int32_t> rounds_of_stitches(const knit::Fabric& fabric);

// Of each stitch: how long its edges to the stitches before and below are, over what they should be; 1 where there are none.
std::vector<double> stretch_of_stitches(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                                        const knit::StitchSize& stitch);

std::vector<Colour> yarn_colours(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                                 const knit::StitchSize& stitch, const YarnLook& look, const Theme& theme);

// Of what is there.
struct YarnUpTo {
  std::uint32_t stitches = 0;  // those before this number are made
  bool whole = false;          // all are, and so is what comes after the last row
  friend bool operator==(const YarnUpTo&, const YarnUpTo&) = default;
};

// Requires a colour and a way outwards for each stitch.
YarnShape yarn_shape(const knit::Yarn& yarn, const YarnUpTo& until, std::span<const glm::vec3> out,
                     std::span<const Colour> colours);

// The faces between the stitches made, moved inwards by `by` and in one colour: what is seen between the loops.
FaceShape yarn_ground(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                      const YarnUpTo& until, std::span<const glm::vec3> out, float by, Colour colour);

}  // namespace app

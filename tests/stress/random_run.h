// A run drawn from a seed: a body that branches, made in code, or a mesh from a file, and parameters that a person might
// set, with rows from contours. The same seed, number and files give the same run on every machine.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"

namespace stress {

// Meshes from files, each fit.
using Meshes = std::vector<std::shared_ptr<const knit::Input>>;

struct RandomRun {
  std::uint32_t dice = 0;  // seeds what is drawn while the run is checked
  std::shared_ptr<const knit::Input> input;
  knit::Parameters parameters;
};
// Two of three runs are on files, where there are any.
RandomRun random_run(std::uint32_t seed, std::uint32_t number, const Meshes& meshes);

// The options of the command line that make the run, those at their defaults left out.
std::string options_of(const RandomRun& run);

}  // namespace stress

// How the parts of this folder give up on a curve: one sentence, caught where the folder is entered (between.h, cycle.h).
#pragma once

#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>

namespace knit {

class CurveRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string three_digits(double value);        // 0.0346, 4, 1e-05
std::string place_text(const glm::dvec3& at);  // (0.524, 0.073, 0.839)

}  // namespace knit

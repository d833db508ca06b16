// A mistake of the program's own, as opposed to a fault in the user's data: checked in release builds too.
//
// Whoever runs the program catches it and adds the command line that leads back to the place.
#pragma once

#include <stdexcept>

namespace knit {

class Bug : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace knit

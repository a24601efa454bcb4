#pragma once
// The answer for a body that does not vibrate as it was asked to.

#include <stdexcept>

namespace idiophone::eigenmodes {

/// A body has no modes, or none up to the frequency that was asked for. what() says which.
class NoModes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace idiophone::eigenmodes

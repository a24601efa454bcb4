#pragma once
// The answer for a body that does not vibrate as it was asked to.

#include <optional>
#include <stdexcept>
#include <string>

namespace idiophone::eigenmodes {

/// A body has no modes, or none up to the frequency that was asked for. what() says which.
class NoModes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// None up to a frequency.
  /// @param body              as the message calls it: "body 'bar'"
  /// @param up_to             that was asked for, Hz
  /// @param lowest_frequency  that it has, Hz; none where it is not known
  NoModes(const std::string& body, double up_to, std::optional<double> lowest_frequency);

  std::optional<double>
      lowest;  ///< frequency of the lowest mode, Hz; none where it is not known, or there are no modes
};

}  // namespace idiophone::eigenmodes

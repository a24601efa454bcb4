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
  /// @param body    as the message calls it: "body 'bar'"
  /// @param up_to   that was asked for, Hz
  /// @param lowest  frequency of its lowest mode, Hz
  NoModes(const std::string& body, double up_to, double lowest);
  /// None up to a frequency, where the lowest mode was not found.
  /// @param reason  why it was not found
  NoModes(const std::string& body, double up_to, const std::string& reason);

  std::optional<double> lowest;  ///< frequency of the lowest mode, Hz, if it is known
};

}  // namespace idiophone::eigenmodes

#include "idiophone/solids/eigenmodes/no_modes.hpp"

#include <fmt/format.h>

namespace idiophone::eigenmodes {

NoModes::NoModes(const std::string& body, double up_to, double lowest_frequency)
    : std::runtime_error(
          fmt::format("{} has no modes up to {} Hz: its lowest one is at {:.6g} Hz", body, up_to, lowest_frequency)),
      lowest(lowest_frequency) {}

NoModes::NoModes(const std::string& body, double up_to, const std::string& reason)
    : std::runtime_error(
          fmt::format("{} has no modes up to {} Hz, and its lowest one was not found: {}", body, up_to, reason)) {}

}  // namespace idiophone::eigenmodes

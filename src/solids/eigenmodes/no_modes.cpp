#include "idiophone/solids/eigenmodes/no_modes.hpp"

#include <fmt/format.h>

namespace idiophone::eigenmodes {

NoModes::NoModes(const std::string& body, double up_to, std::optional<double> lowest_frequency)
    : std::runtime_error(
          fmt::format("{} has no modes up to {} Hz", body, up_to) +
          (lowest_frequency ? fmt::format(": its lowest one is at {:.6g} Hz", *lowest_frequency) : std::string())),
      lowest(lowest_frequency) {}

}  // namespace idiophone::eigenmodes

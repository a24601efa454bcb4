#pragma once
// Sound files that trees name.

#include <memory>
#include <vector>

#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

/// The samples of the file that an argument names, at the audio rate; the first is full scale 1. A file is read once as
/// long as it does not change.
/// @throws deck::DeckError if it can't be read or is empty
[[nodiscard]] std::shared_ptr<const std::vector<double>> recording_of(const Call& call, std::size_t argument);

}  // namespace idiophone::timbre

#pragma once
// Whoever watches work that is done part by part, and may end it.

#include <cstddef>
#include <functional>

namespace idiophone {

/// Is told on each rank after each part of its work; if empty, nobody watches.
/// @param done, expected  parts of all ranks, about
/// @return whether to go on; if not, the work ends with what all ranks have done
using PartWatch = std::function<bool(std::size_t done, std::size_t expected)>;

}  // namespace idiophone

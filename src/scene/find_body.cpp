#include "idiophone/scene/find_body.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace idiophone::scene {

std::size_t find_body(std::span<const Body> bodies, const std::string& name) {
  std::vector<std::string> names;
  std::ranges::transform(bodies, std::back_inserter(names), &Body::name);
  const auto chosen = name.empty() ? names.begin() : std::ranges::find(names, name);
  if (chosen == names.end()) {
    throw std::runtime_error(
        fmt::format("there is no body '{}' in the deck; it has: {}", name, fmt::join(names, ", ")));
  }
  return chosen - names.begin();
}

}  // namespace idiophone::scene

#pragma once
// Names of bodies and contacts in the paths of series.

#include <optional>
#include <string>

namespace idiophone::partials {

/// What a path has between two texts that it begins and ends with; none if it does not.
[[nodiscard]] inline std::optional<std::string> name_between(const std::string& path, const std::string& before,
                                                             const std::string& after) {
  if (!path.starts_with(before) || !path.ends_with(after)) {
    return {};
  }
  return path.substr(before.size(), path.size() - before.size() - after.size());
}

}  // namespace idiophone::partials

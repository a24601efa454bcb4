#pragma once
// The names of things in a message.

#include <map>
#include <string>

namespace idiophone {

/// The keys of a map, in its order, with commas between them: "core, head". (clang 14 can't compile std::views::keys.)
template <class Thing>
[[nodiscard]] std::string listed_names(const std::map<std::string, Thing>& things) {
  std::string names;
  for (const auto& [name, thing] : things) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace idiophone

#pragma once
// Ascending numbers without repetitions: the nodes of a surface, the ghosts of a part, the masses that sound.

#include <algorithm>
#include <vector>

namespace idiophone {

/// Sorts the values and keeps each once.
template <class Value>
void keep_each_once(std::vector<Value>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace idiophone

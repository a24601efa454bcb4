#pragma once
// Whoever watches a search and may end it.

#include <functional>
#include <string>

namespace idiophone::fitting {

/// How far a search is.
struct SearchState {
  int solves = 0;         ///< eigenvalue problems solved
  int expected = 0;       ///< so many in all, as far as can be said now
  std::string best = {};  ///< the best values so far, as text
};

/// Is told after each eigenvalue problem. @return whether to go on; if not, the search ends with the best values so far
using Watch = std::function<bool(const SearchState&)>;

}  // namespace idiophone::fitting

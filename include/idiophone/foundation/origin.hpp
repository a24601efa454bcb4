#pragma once

#include <string>
#include <vector>

namespace idiophone {

/// What a result was computed from. Files keep it.
struct Origin {
  std::string name;                    ///< of the run
  std::string code_version;            ///< e.g. "0.1.0"
  std::string deck_text;               ///< verbatim
  std::vector<std::string> overrides;  ///< the --set arguments, verbatim
};

}  // namespace idiophone

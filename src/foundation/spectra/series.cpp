#include "idiophone/foundation/spectra/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::spectra {

const Series& find_series(const std::vector<Series>& all, const std::string& name) {
  const std::string path = name.starts_with('/') ? name : "/" + name;
  const auto found = std::ranges::find(all, path, &Series::path);
  if (found == all.end()) {
    std::vector<std::string> known;
    std::ranges::transform(all, std::back_inserter(known), &Series::path);
    throw std::invalid_argument(fmt::format("there is no channel {}{}", path, deck::suggestion(path, known)));
  }
  return *found;
}

}  // namespace idiophone::spectra

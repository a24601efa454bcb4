#include "idiophone/solids/solid/pack_layout.hpp"

#include <algorithm>

namespace idiophone::solid {

PackRange common(const PackRange& a, const PackRange& b) {
  const std::size_t begin = std::max(a.begin, b.begin);
  return {begin, std::max(begin, std::min(a.end, b.end))};
}

PackLayout::PackLayout(const mesh::BodyPart& part) {
  const std::size_t count = part.element_ids.size();
  for (std::size_t element = 0; element < count; ++element) {
    const auto region = static_cast<std::size_t>(part.region(element));
    regions_.resize(std::max(regions_.size(), region + 1), {first_.size(), first_.size()});
    if (regions_[region].begin == first_.size() || element == first_element(first_.size() - 1) + lanes) {
      first_.push_back(static_cast<Index>(element));
      regions_[region].end = first_.size();
    }
  }
  first_.push_back(static_cast<Index>(count));
}

std::size_t PackLayout::pack_of(std::size_t element) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(first_, static_cast<Index>(element)) - first_.begin()) - 1;
}

}  // namespace idiophone::solid

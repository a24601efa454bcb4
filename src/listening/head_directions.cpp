#include "idiophone/listening/head_directions.hpp"

namespace idiophone::listening {

void HeadDirections::keep_up(std::int64_t sample, const std::function<std::int64_t(std::size_t triangle)>& nearest) {
  const bool due = age(sample) == 0;
  for (std::size_t triangle = 0; triangle < present_.size(); ++triangle) {
    if (!due && present_[triangle] != none) {
      continue;
    }
    const std::int64_t found = nearest(triangle);
    before_[triangle] = present_[triangle] == none ? found : present_[triangle];
    present_[triangle] = found;
  }
}

Shares HeadDirections::shares(std::int64_t sample, std::size_t triangle) const {
  if (before_[triangle] == present_[triangle]) {
    return {Share{present_[triangle], 1.0}, {}};
  }
  const double gone = static_cast<double>(age(sample)) / renewal_;
  return {Share{before_[triangle], 1.0 - gone}, {present_[triangle], gone}};
}

void HeadDirections::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  row.value(present_[triangle]);
  row.value(before_[triangle]);
}

}  // namespace idiophone::listening

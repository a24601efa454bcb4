#include "idiophone/air/receivers/head_directions.hpp"

namespace idiophone::receivers {

void HeadDirections::update(std::int64_t sample, const std::function<std::int64_t(std::size_t triangle)>& nearest) {
  const bool due = age(sample) == 0;
  for (std::size_t triangle = 0; triangle < current_.size(); ++triangle) {
    if (!due && current_[triangle] != none) {
      continue;
    }
    const std::int64_t found = nearest(triangle);
    previous_[triangle] = current_[triangle] == none ? found : current_[triangle];
    current_[triangle] = found;
  }
}

Crossfade HeadDirections::crossfade(std::int64_t sample, std::size_t triangle) const {
  if (previous_[triangle] == current_[triangle]) {
    return {FilterWeight{current_[triangle], 1.0}, {}};
  }
  const double progress = static_cast<double>(age(sample)) / interval_;
  return {FilterWeight{previous_[triangle], 1.0 - progress}, {current_[triangle], progress}};
}

void HeadDirections::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  row.value(current_[triangle]);
  row.value(previous_[triangle]);
}

}  // namespace idiophone::receivers

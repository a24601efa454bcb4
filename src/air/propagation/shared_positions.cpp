#include "idiophone/air/propagation/shared_positions.hpp"

#include <algorithm>

namespace idiophone::propagation {

SharedPositions::SharedPositions(const std::vector<Index>& vertices, MPI_Comm communicator)
    : vertices_(parallel::gather_all(std::span<const Index>(vertices), communicator)),
      count_(vertices_.values.empty() ? 0 : static_cast<std::size_t>(std::ranges::max(vertices_.values)) + 1),
      own_(vertices.size()),
      gather_(vertices_.counts, communicator) {}

std::vector<float> SharedPositions::share(std::span<const Vector3> positions) {
  std::vector<double> own;
  for (const Vector3& position : positions) {
    own.insert(own.end(), position.begin(), position.end());
  }
  std::vector<float> all(3 * count_);
  begin(own);
  finish(all);
  return all;
}

void SharedPositions::begin(std::span<const double> positions) {
  for (std::size_t i = 0; i < 3 * own_.size(); ++i) {
    own_[i / 3][i % 3] = static_cast<float>(positions[i]);
  }
  gather_.begin(own_);
}

void SharedPositions::finish(std::span<float> positions) {
  const std::span<const Point> all = gather_.finish();
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::ranges::copy(all[i], &positions[3UL * vertices_.values[i]]);
  }
}

}  // namespace idiophone::propagation

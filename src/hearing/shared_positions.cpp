#include "idiophone/hearing/shared_positions.hpp"

#include <algorithm>
#include <exception>

namespace idiophone::hearing {

SharedPositions::SharedPositions(const std::vector<Index>& vertices, MPI_Comm communicator)
    : communicator_(communicator),
      vertices_(parallel::gather_all(std::span<const Index>(vertices), communicator)),
      count_(vertices_.values.empty() ? 0 : static_cast<std::size_t>(std::ranges::max(vertices_.values)) + 1),
      own_(3 * vertices.size()),
      all_(3 * vertices_.values.size()) {
  MPI_Type_contiguous(3, MPI_FLOAT, &point_);
  MPI_Type_commit(&point_);
}

SharedPositions::~SharedPositions() {
  // While an error takes the job down, the other ranks may never begin.
  if (std::uncaught_exceptions() == 0 || vertices_.counts.size() == 1) {
    wait();
  }
  MPI_Type_free(&point_);
}

void SharedPositions::begin(std::span<const double> positions) {
  std::ranges::transform(positions.first(own_.size()), own_.begin(), [](double x) { return static_cast<float>(x); });
  MPI_Iallgatherv(own_.data(), static_cast<int>(own_.size() / 3), point_, all_.data(), vertices_.counts.data(),
                  vertices_.offsets.data(), point_, communicator_, &request_);
}

void SharedPositions::wait() {
  MPI_Wait(&request_, MPI_STATUS_IGNORE);  // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): begin() made the request
}

void SharedPositions::finish(std::span<float> positions) {
  wait();
  for (std::size_t i = 0; i < vertices_.values.size(); ++i) {
    std::copy_n(&all_[3 * i], 3, &positions[3 * static_cast<std::size_t>(vertices_.values[i])]);
  }
}

}  // namespace idiophone::hearing

#include "body_rows.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::motion {

BodyRows::BodyRows(const mesh::Part& part, const mesh::BodyPart& body, int width, MPI_Comm communicator)
    : communicator_(communicator),
      width_(width),
      row_(width_, MPI_DOUBLE),
      counts_(parallel::gather(static_cast<int>(body.owned_end - body.owned_begin), communicator)),
      offsets_(parallel::offsets_of(counts_)) {
  const auto rows = static_cast<std::size_t>(offsets_.back()) + counts_.back();
  size_ = parallel::is_root(communicator) ? rows * width_ : 0;
  if (is_whole()) {
    return;  // one rank's nodes ascend
  }
  places_.resize(size_ / width_);
  MPI_Gatherv(part.node_ids.data() + body.owned_begin, body.owned_end - body.owned_begin, MPI_INT32_T, places_.data(),
              counts_.data(), offsets_.data(), MPI_INT32_T, 0, communicator);
  // The nodes of a body have numbers one after another.
  const Index first = places_.empty() ? 0 : std::ranges::min(places_);
  std::ranges::for_each(places_, [&](Index& place) { place -= first; });
}

void BodyRows::scatter(std::span<const double> whole, std::span<double> own) const {
  if (is_whole()) {
    std::ranges::copy(whole, own.begin());
    return;
  }
  std::vector<double> sorted(size());
  for (std::size_t row = 0; row < places_.size(); ++row) {
    std::copy_n(&whole[width_ * places_[row]], width_, &sorted[width_ * row]);
  }
  MPI_Scatterv(sorted.data(), counts_.data(), offsets_.data(), row_.get(), own.data(),
               counts_[parallel::rank_of(communicator_)], row_.get(), 0, communicator_);
}

void BodyRows::gather(std::span<const double> own, std::span<double> whole) const {
  if (is_whole()) {
    std::ranges::copy(own, whole.begin());
    return;
  }
  std::vector<double> sorted(size());
  MPI_Gatherv(own.data(), counts_[parallel::rank_of(communicator_)], row_.get(), sorted.data(), counts_.data(),
              offsets_.data(), row_.get(), 0, communicator_);
  for (std::size_t row = 0; row < places_.size(); ++row) {
    std::copy_n(&sorted[width_ * row], width_, &whole[width_ * places_[row]]);
  }
}

}  // namespace idiophone::motion

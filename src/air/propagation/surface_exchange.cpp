#include "surface_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/messages.hpp"

namespace idiophone::propagation {

namespace {

constexpr int velocity_tag = 0;
constexpr int force_tag = 1;

/// Planes from `low` to `high`; none if high < low.
struct PlaneRange {
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();

  [[nodiscard]] bool reaches(const waves::Slab& slab) const { return low < slab.end() && high >= slab.begin(); }
};

/// The planes of the triangles and of the air next to them.
PlaneRange planes_of(std::span<const Index> triangles, const waves::Obstruction& obstruction, const waves::Grid& grid) {
  PlaneRange planes;
  for (const Index triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const int plane = static_cast<int>(std::floor(grid.in_cells(obstruction.corner(triangle, k))[2]));
      planes.low = std::min(planes.low, plane - 1);
      planes.high = std::max(planes.high, plane + 1);
    }
  }
  return planes;
}

/// Calls visit(place in triangles, share) for the shares of these triangles. Both are ascending.
template <class Visitor>
void for_common(std::span<const Index> triangles, const std::vector<waves::ForceShare>& shares, Visitor visit) {
  std::size_t place = 0;
  for (const waves::ForceShare& share : shares) {
    while (place < triangles.size() && triangles[place] < share.triangle) {
      ++place;
    }
    if (place < triangles.size() && triangles[place] == share.triangle) {
      visit(place, share);
    }
  }
}

}  // namespace

SurfaceExchange::SurfaceExchange(const std::vector<Index>& triangles, MPI_Comm communicator)
    : triangles_(parallel::gather_all(std::span<const Index>(triangles), communicator)) {
  MPI_Comm_dup(communicator, &communicator_);
}

SurfaceExchange::~SurfaceExchange() {
  MPI_Comm_free(&communicator_);
}

void SurfaceExchange::find_near(const waves::Obstruction& obstruction, const waves::Grid& grid) {
  const int here = parallel::rank_of(communicator_);
  const int ranks = parallel::size_of(communicator_);
  const PlaneRange own_planes = planes_of(triangles_of(here), obstruction, grid);
  const waves::Slab own_slab = waves::Slab::of_rank(grid, here, ranks);
  slabs_.clear();
  surfaces_.clear();
  for (int rank = 0; rank < ranks; ++rank) {
    if (own_planes.reaches(waves::Slab::of_rank(grid, rank, ranks))) {
      slabs_.push_back(rank);
    }
    if (planes_of(triangles_of(rank), obstruction, grid).reaches(own_slab)) {
      surfaces_.push_back(rank);
    }
  }
}

void SurfaceExchange::send_velocities(std::span<const double> own, std::span<double> all) const {
  parallel::Messages messages(communicator_);
  for (const int rank : slabs_) {
    messages.send(std::vector<double>(own.begin(), own.end()), rank, velocity_tag);
  }
  for (const int rank : surfaces_) {
    const std::vector<double> velocities = messages.receive<double>(rank, velocity_tag);
    const std::span<const Index> triangles = triangles_of(rank);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      all[triangles[i]] = velocities[i];
    }
  }
}

void SurfaceExchange::return_forces(const std::vector<waves::ForceShare>& shares, std::span<double> force,
                                    std::span<double> resistance) const {
  parallel::Messages messages(communicator_);
  for (const int rank : surfaces_) {
    std::vector<waves::ForceShare> wanted;
    for_common(triangles_of(rank), shares,
               [&](std::size_t /*place*/, const waves::ForceShare& share) { wanted.push_back(share); });
    messages.send(std::move(wanted), rank, force_tag);
  }
  std::ranges::fill(force, 0.0);
  std::ranges::fill(resistance, 0.0);
  for (const int rank : slabs_) {
    for_common(triangles_of(parallel::rank_of(communicator_)), messages.receive<waves::ForceShare>(rank, force_tag),
               [&](std::size_t place, const waves::ForceShare& share) {
                 force[place] += share.force;
                 resistance[place] += share.resistance;
               });
  }
}

}  // namespace idiophone::propagation

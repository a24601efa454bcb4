#include "surface_exchange.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>

#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::propagation {

namespace {

constexpr int velocity_tag = 0;
constexpr int force_tag = 1;

/// The cells of the triangles, and those next to them.
waves::CellBox cells_of(std::span<const Index> triangles, const waves::Obstruction& obstruction,
                        const waves::Grid& grid) {
  waves::CellBox box;
  box.from.fill(std::numeric_limits<int>::max());
  box.to.fill(std::numeric_limits<int>::min());
  for (const Index triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 3> cell = waves::cell_at(grid.in_cells(obstruction.corner(triangle, k)));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.from.at(axis) = std::min(box.from.at(axis), cell.at(axis) - 1);
        box.to.at(axis) = std::max(box.to.at(axis), cell.at(axis) + 2);
      }
    }
  }
  return box;
}

bool meet(const waves::CellBox& a, const waves::CellBox& b) {
  return !waves::common(a, b).is_empty();
}

/// The order of the triangles, then that of the cells of the grid.
auto order(const waves::ForceShare& share) {
  return std::tuple(share.triangle, share.cell[2], share.cell[1], share.cell[0]);
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

void add(const std::array<double, 3>& values, std::span<double, 3> sums) {
  std::ranges::transform(sums, values, sums.begin(), std::plus<>());
}

/// The sum of each triangle's shares in each plane of the grid, upwards.
/// @param shares  in their order
std::vector<waves::ForceShare> sums_of_planes(const std::vector<waves::ForceShare>& shares) {
  std::vector<waves::ForceShare> sums;
  for (const waves::ForceShare& share : shares) {
    if (sums.empty() || sums.back().triangle != share.triangle || sums.back().cell[2] != share.cell[2]) {
      sums.push_back(share);
    } else {
      add(share.force, sums.back().force);
      add(share.resistance, sums.back().resistance);
    }
  }
  return sums;
}

}  // namespace

SurfaceExchange::SurfaceExchange(const std::vector<Index>& triangles, MPI_Comm communicator)
    : triangles_(parallel::gather_all(std::span<const Index>(triangles), communicator)) {
  MPI_Comm_dup(communicator, &communicator_);
}

SurfaceExchange::~SurfaceExchange() {
  MPI_Comm_free(&communicator_);
}

void SurfaceExchange::find_near(const waves::Obstruction& obstruction, const waves::Division& division) {
  const int here = parallel::rank_of(communicator_);
  const waves::CellBox own_surface = cells_of(triangles_of(here), obstruction, division.grid());
  cells_.clear();
  surfaces_.clear();
  for (int rank = 0; rank < division.ranks(); ++rank) {
    if (meet(own_surface, division.cells(rank))) {
      cells_.push_back(rank);
    }
    if (meet(cells_of(triangles_of(rank), obstruction, division.grid()), division.cells(here))) {
      surfaces_.push_back(rank);
    }
  }
}

void SurfaceExchange::send_velocities(std::span<const double> own, std::span<double> all) const {
  parallel::Messages messages(communicator_);
  for (const int rank : cells_) {
    messages.send(std::vector<double>(own.begin(), own.end()), rank, velocity_tag);
  }
  for (const int rank : surfaces_) {
    const std::vector<double> velocities = messages.receive<double>(rank, velocity_tag);
    const std::span<const Index> triangles = triangles_of(rank);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      std::copy_n(&velocities[3 * i], 3, &all[3UL * triangles[i]]);
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
  for_common(triangles_of(parallel::rank_of(communicator_)), sums_of_planes(receive_shares(messages)),
             [&](std::size_t place, const waves::ForceShare& share) {
               add(share.force, force.subspan(3 * place).first<3>());
               add(share.resistance, resistance.subspan(3 * place).first<3>());
             });
}

std::vector<waves::ForceShare> SurfaceExchange::receive_shares(const parallel::Messages& messages) const {
  std::vector<waves::ForceShare> shares;
  for (const int rank : cells_) {
    const auto of_rank = messages.receive<waves::ForceShare>(rank, force_tag);
    const auto middle = shares.insert(shares.end(), of_rank.begin(), of_rank.end());
    std::inplace_merge(shares.begin(), middle, shares.end(),
                       [](const auto& a, const auto& b) { return order(a) < order(b); });
  }
  return shares;
}

}  // namespace idiophone::propagation

#include "idiophone/air/waves/surface_coupling.hpp"

#include <algorithm>
#include <functional>

#include "surface_pieces.hpp"

namespace idiophone::waves {

SurfaceCoupling::SurfaceCoupling(const Subdomain& subdomain, const Obstruction& obstruction, std::size_t moving,
                                 const CutCells& cut_cells, double courant) {
  for (std::size_t triangle = 0; triangle < moving; ++triangle) {
    add_triangle(subdomain, obstruction, static_cast<Index>(triangle), cut_cells);
  }
  const double face = subdomain.grid().cell * subdomain.grid().cell;
  for (const Node& node : cut_cells.nodes()) {
    per_area_.push_back(static_cast<float>(courant / face) / node.volume);
  }
  find_resistances(moving, cut_cells.nodes().size());
}

void SurfaceCoupling::add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                                   const CutCells& cut_cells) {
  const auto begin = std::ssize(fronts_);
  for_each_front(subdomain, obstruction, triangle, cut_cells, [&](Index node, const SurfacePiece& piece) {
    auto front = std::ranges::find(fronts_.begin() + begin, fronts_.end(), node, &Front::node);
    if (front == fronts_.end()) {
      front = fronts_.insert(front, {.node = node, .areas = {}});
    }
    for (std::size_t k = 0; k < 3; ++k) {
      front->areas.at(k) += static_cast<float>(piece.area * piece.weights.at(k));
    }
  });
  std::ranges::sort(fronts_.begin() + begin, fronts_.end(), {}, &Front::node);
  for (auto front = fronts_.begin() + begin; front != fronts_.end(); ++front) {
    shares_.push_back(
        {.triangle = triangle, .cell = cut_cells.nodes()[front->node].cell, .force = {}, .resistance = {}});
  }
}

/// Two corners whose triangles have a node in common feel each other's velocity. These are the sums of the rows of that
/// symmetric matrix, so a diagonal matrix of them is at least as large.
void SurfaceCoupling::find_resistances(std::size_t moving, std::size_t nodes) {
  std::vector<float> half_step(nodes);  // what a velocity of 1/(rho c) adds to the pressures
  add(std::vector<float>(3 * moving, 0.5F), half_step);
  static_cast<void>(forces(half_step));
  for (ForceShare& share : shares_) {
    share.resistance = share.force;
  }
}

void SurfaceCoupling::add(std::span<const float> change, std::span<float> sources) const {
  std::ranges::fill(sources, 0.0F);
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    const auto& [node, areas] = fronts_[i];
    const float* const at_corners = &change[3UL * shares_[i].triangle];
    sources[node] += areas[0] * at_corners[0] + areas[1] * at_corners[1] + areas[2] * at_corners[2];
  }
  std::ranges::transform(sources, per_area_, sources.begin(), std::multiplies<>());
}

const std::vector<ForceShare>& SurfaceCoupling::forces(std::span<const float> pressure) {
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      shares_[i].force.at(k) = static_cast<double>(fronts_[i].areas.at(k)) * pressure[fronts_[i].node];
    }
  }
  return shares_;
}

}  // namespace idiophone::waves

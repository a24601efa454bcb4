#include "idiophone/study/bench/workpiece.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::bench {

namespace {

constexpr int more_modes = 4;  // that a tap has, too

Eigen::Map<const Eigen::VectorXd> shape_of(const eigenmodes::Mode& mode) {
  return {mode.shape.data(), static_cast<Eigen::Index>(mode.shape.size())};
}

/// Where a mode is among others. @throws OutsideOfModel where none is like it
std::size_t find(const eigenmodes::Mode& wanted, const std::vector<eigenmodes::Mode>& modes) {
  constexpr double least = 0.5;
  const auto likeness = [&](const eigenmodes::Mode& mode) {
    const double cosine = shape_of(wanted).normalized().dot(shape_of(mode).normalized());
    return cosine * cosine;
  };
  const auto found = std::ranges::max_element(modes, {}, likeness);
  if (likeness(*found) < least) {
    throw OutsideOfModel(fmt::format(
        "no mode of the body with the cuts resembles that at {:.1f} Hz: give the deck a mesh with the cuts, and leave "
        "them out of --cuts",
        wanted.frequency));
  }
  return static_cast<std::size_t>(found - modes.begin());
}

}  // namespace

Workpiece::Workpiece(const scene::Solids& solids, const std::string& side, const std::vector<int>& numbers,
                     eigenmodes::MassMatrix mass)
    : Workpiece(solids, mesh::read_mesh(solids.bodies.front()), side, numbers, mass) {}

Workpiece::Workpiece(const scene::Solids& solids, mesh::Mesh mesh, const std::string& side,
                     const std::vector<int>& numbers, eigenmodes::MassMatrix mass)
    : solids_(solids), side_(read_side(side, mesh)), mesh_(std::move(mesh), side_) {
  attachments_ = motion::attach(solids, {mesh_.uncut()});
  options_ = {.count = std::ranges::max(numbers) + more_modes, .mass = mass};
  uncut_ = solve(mesh_.uncut());
  std::ranges::transform(numbers, std::back_inserter(uncut_.tuned),
                         [](int number) { return static_cast<std::size_t>(number) - 1; });
}

Workpiece::Solved Workpiece::solve(mesh::Mesh mesh) const {
  const mesh::Part part = mesh::distribute({mesh}, MPI_COMM_SELF, motion::coupled_nodes(attachments_));
  eigenmodes::Modes found = eigenmodes::find_modes(solids_, part, attachments_, options_, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes = eigenmodes::whole_shapes(found, part, MPI_COMM_SELF);
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    found.modes[mode].shape = std::move(shapes[mode]);
  }
  return {std::move(mesh), std::move(found.modes), {}};
}

Workpiece::Solved Workpiece::with(const std::vector<Cut>& cuts) const {
  if (cuts.empty()) {
    return uncut_;
  }
  Solved result = solve(mesh_.with(cuts));
  for (const std::size_t mode : uncut_.tuned) {
    result.tuned.push_back(find(uncut_.modes[mode], result.modes));
  }
  return result;
}

eigenmodes::RemovalSlopes Workpiece::removal_of(const Solved& body) const {
  std::vector<eigenmodes::Mode> modes;
  std::ranges::transform(body.tuned, std::back_inserter(modes), [&](std::size_t mode) { return body.modes[mode]; });
  return eigenmodes::removal_slopes(solids_, body.mesh, attachments_, modes);
}

CutModel Workpiece::model(const std::vector<Cut>& earlier, const Solved& here) const {
  return [this, &earlier, &here](const std::vector<Cut>& more) {
    std::vector<Cut> all = earlier;
    all.insert(all.end(), more.begin(), more.end());
    const Solved body = more.empty() ? here : with(all);
    CutBody result{Eigen::VectorXd(body.tuned.size()), strips_of(body.mesh, removal_of(body), side_)};
    for (std::size_t p = 0; p < body.tuned.size(); ++p) {
      result.moved[static_cast<Eigen::Index>(p)] =
          1200 * std::log2(body.modes[body.tuned[p]].frequency / here.modes[here.tuned[p]].frequency);
    }
    return result;
  };
}

}  // namespace idiophone::bench

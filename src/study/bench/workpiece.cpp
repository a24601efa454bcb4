#include "idiophone/study/bench/workpiece.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/study/fitting/recognised_modes.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::bench {

namespace {

constexpr int more_modes = 4;  // that a tap has, too

/// [3 x nodes, modes] of length 1 each
Eigen::MatrixXd directions_of(const std::vector<eigenmodes::Mode>& modes) {
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(modes.front().shape.size()),
                         static_cast<Eigen::Index>(modes.size()));
  for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
    const std::vector<double>& shape = modes[static_cast<std::size_t>(mode)].shape;
    shapes.col(mode) = Eigen::VectorXd::Map(shape.data(), shapes.rows()).normalized();
  }
  return shapes;
}

}  // namespace

Workpiece::Workpiece(const scene::Solids& solids, mesh::Mesh mesh, const Side& side, const std::vector<int>& numbers,
                     eigenmodes::MassMatrix mass)
    : materials_(solids.materials.begin(), solids.materials.end()),
      solids_(solids),
      side_(side),
      mesh_(std::move(mesh), side_),
      attachments_(motion::attach(solids, {mesh_.uncut()})),
      options_{.count = std::ranges::max(numbers) + more_modes, .mass = mass} {
  solids_.materials = materials_;
  uncut_ = solve(mesh_.uncut());
  for (std::size_t mode = 0; mode < uncut_.modes.size(); ++mode) {
    uncut_.places.emplace_back(mode);
  }
  std::ranges::transform(numbers, std::back_inserter(uncut_.tuned),
                         [](int number) { return static_cast<std::size_t>(number) - 1; });
}

const scene::Material& Workpiece::material() const {
  return materials_[solids_.bodies.front().material];
}

void Workpiece::take(const scene::Material& material) {
  materials_[solids_.bodies.front().material] = material;
  is_of_deck_ = false;
}

mesh::Part Workpiece::part_of(const mesh::Mesh& mesh) const {
  return mesh::distribute({mesh}, MPI_COMM_SELF, motion::coupled_nodes(attachments_));
}

Workpiece::Solved Workpiece::solve(mesh::Mesh mesh) const {
  const mesh::Part part = part_of(mesh);
  eigenmodes::Modes found = eigenmodes::find_modes(solids_, part, attachments_, options_, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes = eigenmodes::whole_shapes(found, part, MPI_COMM_SELF);
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    found.modes[mode].shape = std::move(shapes[mode]);
  }
  return {std::move(mesh), std::move(found.modes), {}, {}};
}

Workpiece::Solved Workpiece::with(const std::vector<Cut>& cuts) const {
  if (cuts.empty() && is_of_deck_) {
    return uncut_;
  }
  std::vector<Cut> modelled = cuts;
  for (Cut& cut : modelled) {
    cut.depth = modelled_depth(cut);
  }
  Solved result = solve(mesh_.with(modelled));
  const Eigen::MatrixXd cosines = directions_of(uncut_.modes).transpose() * directions_of(result.modes);
  result.places = fitting::recognise(cosines.cwiseAbs2()).modes;
  for (const std::size_t mode : uncut_.tuned) {
    if (!result.places[mode]) {
      throw OutsideOfModel(fmt::format(
          "no mode of the body with the cuts resembles that at {:.1f} Hz: give the deck a mesh with the cuts, and "
          "leave them out of --cuts",
          uncut_.modes[mode].frequency));
    }
    result.tuned.push_back(*result.places[mode]);
  }
  return result;
}

Workpiece::Slopes Workpiece::slopes_of(const Solved& body, const std::vector<std::size_t>& places) const {
  std::vector<eigenmodes::Mode> modes;
  std::ranges::transform(places, std::back_inserter(modes), [&](std::size_t mode) { return body.modes[mode]; });
  eigenmodes::RemovalSlopes removal = eigenmodes::removal_slopes(solids_, body.mesh, attachments_, modes);
  Strips strips = strips_of(body.mesh, removal, side_);
  return {std::move(removal), std::move(strips)};
}

fitting::MaterialSlopes Workpiece::material_slopes_of(const Solved& body) const {
  return fitting::material_slopes(solids_, part_of(body.mesh), body.modes);
}

CutModel Workpiece::model(const std::vector<Cut>& earlier, const Solved& here, const Strips& strips) const {
  return [this, &earlier, &here, &strips](const std::vector<Cut>& more) {
    if (more.empty()) {
      return CutBody{Eigen::VectorXd::Zero(std::ssize(here.tuned)), strips};
    }
    std::vector<Cut> all = earlier;
    all.insert(all.end(), more.begin(), more.end());
    const Solved body = with(all);
    CutBody result{Eigen::VectorXd(body.tuned.size()), slopes_of(body, body.tuned).strips};
    for (std::size_t p = 0; p < body.tuned.size(); ++p) {
      result.moved[static_cast<Eigen::Index>(p)] =
          partials::cents(body.modes[body.tuned[p]].frequency, here.modes[here.tuned[p]].frequency);
    }
    return result;
  };
}

}  // namespace idiophone::bench

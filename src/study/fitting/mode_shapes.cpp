#include "mode_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"

namespace idiophone::fitting {

namespace {

/// Adds the box that the nodes span, and their places in it.
void add_places(const std::vector<Vector3>& nodes, ModeShapes& shapes) {
  Eigen::Matrix3Xd places(3, nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    places.col(static_cast<Eigen::Index>(n)) = nodes[n];
  }
  const Vector3 lowest = places.rowwise().minCoeff();
  shapes.sides = (places.rowwise().maxCoeff() - lowest).cwiseMax(1e-300);
  shapes.places = shapes.sides.cwiseInverse().asDiagonal() * (places.colwise() - lowest);
}

/// The node of `others` that is nearest to each place. [places]
std::vector<Eigen::Index> nearest_nodes(const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& others) {
  std::vector<Eigen::Index> nearest(places.cols());
  for (Eigen::Index n = 0; n < places.cols(); ++n) {
    (others.colwise() - places.col(n)).colwise().squaredNorm().minCoeff(&nearest[n]);
  }
  return nearest;
}

struct MeshedModes {
  mesh::Mesh mesh;
  std::vector<eigenmodes::Mode> modes;
};

MeshedModes meshed_modes(const scene::Solids& solids, const eigenmodes::Options& options) {
  std::vector<mesh::Mesh> meshes = {mesh::read_mesh(solids.bodies.front())};
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  eigenmodes::Modes found =
      eigenmodes::find_modes(solids, part, motion::attach(solids, meshes), options, MPI_COMM_SELF);
  return {std::move(meshes.front()), std::move(found.modes)};
}

}  // namespace

ModeShapes shapes_of(const mesh::Mesh& mesh, const std::vector<eigenmodes::Mode>& modes) {
  ModeShapes result;
  for (const eigenmodes::Mode& mode : modes) {
    result.frequencies.push_back(mode.frequency);
    result.decay_times.push_back(mode.decay_time);
    result.shapes.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(mode.shape.data(), static_cast<Eigen::Index>(mode.shape.size())));
  }
  add_places(mesh.nodes, result);
  return result;
}

ModeShapes mode_shapes(const scene::Solids& solids, const eigenmodes::Options& options) {
  const auto [mesh, modes] = meshed_modes(solids, options);
  return shapes_of(mesh, modes);
}

std::vector<double> mesh_errors_of(const scene::Solids& solids, const eigenmodes::Options& options) {
  auto [mesh, modes] = meshed_modes(solids, options);
  std::vector<std::vector<double>> shapes;
  for (eigenmodes::Mode& mode : modes) {
    shapes.push_back(std::move(mode.shape));
  }
  std::vector<double> errors =
      eigenmodes::mesh_errors(solids, {mesh}, options.mass, shapes, eigenmodes::Estimates::quick).cents;
  errors.resize(shapes.size(), std::numeric_limits<double>::quiet_NaN());
  return errors;
}

std::vector<std::string> kinds_of(const ModeShapes& shapes) {
  std::vector<Vector3> nodes;
  for (Eigen::Index n = 0; n < shapes.places.cols(); ++n) {
    nodes.emplace_back(shapes.sides.cwiseProduct(shapes.places.col(n)));
  }
  std::vector<std::vector<double>> fields;
  std::ranges::transform(shapes.shapes, std::back_inserter(fields),
                         [](const Eigen::VectorXd& shape) { return std::vector<double>(shape.begin(), shape.end()); });
  return mode_kinds::kinds_of(nodes, fields);
}

Eigen::MatrixXd similarities(const ModeShapes& known, const std::vector<int>& chosen, const ModeShapes& others) {
  const std::vector<Eigen::Index> nearest = nearest_nodes(known.places, others.places);
  Eigen::MatrixXd result(chosen.size(), others.shapes.size());
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    const Eigen::Map<const Eigen::Matrix3Xd> shape(others.shapes[j].data(), 3, others.places.cols());
    const Eigen::Matrix3Xd sampled = shape(Eigen::all, nearest);
    const Eigen::Map<const Eigen::VectorXd> b(sampled.data(), sampled.size());
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const Eigen::VectorXd& a = known.shapes[chosen[i]];
      result(i, j) = std::pow(a.dot(b), 2) / (a.squaredNorm() * b.squaredNorm());
    }
  }
  return result;
}

}  // namespace idiophone::fitting

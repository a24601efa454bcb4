#pragma once
// Blocks of cells bent into bodies, for estimates of the mesh's error against solutions of high order on the same
// shape.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {

/// A body that a block becomes when its points are moved.
struct MappedBlock {
  std::string name;
  Vector3 size;                                                                               ///< of the block, m
  std::function<Vector3(const Vector3&)> place = [](const Vector3& point) { return point; };  ///< of a point of it
  bool is_clamped = false;                                                                    ///< at x = 0
  std::array<int, 3> exact_cells = {4, 2, 1};
  element::Type exact_type = element::hex(7, 5);

  [[nodiscard]] VibratingBody body(element::Type type, const std::array<int, 3>& cells) const {
    VibratingBody result = block(type, size, cells);
    std::ranges::transform(result.mesh.nodes, result.mesh.nodes.begin(), place);
    if (is_clamped) {
      result.fix("x0");
    }
    return result;
  }
};

/// Modes of high order, and their motion at points of the block.
class ExactModes {
 public:
  ExactModes(const MappedBlock& shape, int count)
      : shape_(shape), modes_(shape.body(shape.exact_type, shape.exact_cells).find({.count = count}, MPI_COMM_SELF)) {
    const mesh::Mesh mesh = support::block_mesh(shape.exact_type, shape.size, shape.exact_cells);
    for (Index element = 0; element < mesh.element_count(); ++element) {
      const auto nodes = mesh.element_nodes(element);
      const Vector3 middle = (mesh.nodes[nodes.front()] + mesh.nodes[nodes.back()]) / 2;
      elements_[cell_of(middle)] = {nodes.begin(), nodes.end()};
    }
  }

  /// The frequency (Hz) of the mode that is most like a motion; 0 where none is much like it.
  /// @param points  of the block, m
  /// @param shape   [3 x points]
  [[nodiscard]] double frequency_of(const std::vector<Vector3>& points, const std::vector<double>& shape) const {
    const Eigen::MatrixXd at_points = shapes_at(points);
    const Eigen::Map<const Eigen::VectorXd> wanted(shape.data(), static_cast<Eigen::Index>(shape.size()));
    const Eigen::VectorXd likeness =
        (at_points.transpose() * wanted).cwiseAbs().cwiseQuotient(at_points.colwise().norm().transpose()) /
        wanted.norm();
    Eigen::Index best = 0;
    return likeness.maxCoeff(&best) > 0.6 ? modes_.modes[best].frequency : 0.0;
  }

 private:
  [[nodiscard]] std::array<int, 3> cell_of(const Vector3& point) const {
    std::array<int, 3> cell{};
    for (int d = 0; d < 3; ++d) {
      const int cells = shape_.exact_cells[d];
      cell[d] = std::clamp(static_cast<int>(point[d] / shape_.size[d] * cells), 0, cells - 1);
    }
    return cell;
  }

  [[nodiscard]] Eigen::MatrixXd shapes_at(const std::vector<Vector3>& points) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * std::ssize(points), std::ssize(modes_.modes));
    for (Eigen::Index p = 0; p < std::ssize(points); ++p) {
      const auto cell = cell_of(points[p]);
      Vector3 xi;
      for (int d = 0; d < 3; ++d) {
        xi[d] = 2 * (points[p][d] / shape_.size[d] * shape_.exact_cells[d] - cell[d]) - 1;
      }
      const Eigen::VectorXd functions = element::shape_functions(shape_.exact_type, xi);
      const std::vector<Index>& nodes = elements_.at(cell);
      for (Eigen::Index mode = 0; mode < result.cols(); ++mode) {
        for (std::size_t a = 0; a < nodes.size(); ++a) {
          result.block<3, 1>(3 * p, mode) += functions[static_cast<Eigen::Index>(a)] *
                                             Vector3::Map(&modes_.modes[mode].shape[3 * std::size_t(nodes[a])]);
        }
      }
    }
    return result;
  }

  const MappedBlock& shape_;
  Modes modes_;
  std::map<std::array<int, 3>, std::vector<Index>> elements_;  ///< nodes by cell
};

/// An estimate and the truth, cents.
struct Judged {
  double frequency;  ///< Hz
  double estimate;
  double error;
};

inline std::vector<double> estimates(const VibratingBody& body, const Modes& modes, MassMatrix mass) {
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes.modes, std::back_inserter(shapes), &Mode::shape);
  return mesh_errors(body.scene, {body.mesh}, mass, shapes);
}

/// The lowest modes of a mesh whose likes are among the exact ones.
inline std::vector<Judged> judged(const MappedBlock& shape, const ExactModes& exact, element::Type type,
                                  const std::array<int, 3>& cells, int count, MassMatrix mass = MassMatrix::lumped) {
  VibratingBody body = shape.body(type, cells);
  const Modes modes = body.find({.count = count, .mass = mass}, MPI_COMM_SELF);
  const std::vector<double> errors = estimates(body, modes, mass);
  const std::vector<Vector3> points = support::block_mesh(type, shape.size, cells).nodes;
  std::vector<Judged> result;
  for (std::size_t mode = 0; mode < modes.modes.size(); ++mode) {
    const double frequency = modes.modes[mode].frequency;
    if (const double truth = exact.frequency_of(points, modes.modes[mode].shape); truth > 0) {
      result.push_back({frequency, errors[mode], 1200 * std::log2(frequency / truth)});
    }
  }
  return result;
}

}  // namespace idiophone::eigenmodes

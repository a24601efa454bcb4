#include "idiophone/study/mode_kinds/mode_kinds.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "body_form.hpp"
#include "forms_of_modes.hpp"

namespace idiophone::mode_kinds {

namespace {

/// Whether a shape is nearly a rigid motion a + b x r everywhere. A mean over the nodes would not do: most of them can
/// be at the heavy end of a cantilever, which hardly bends.
bool is_rigid(const LocalShape& shape) {
  constexpr double largest_bend = 0.1;  // of the largest displacement
  const auto count = static_cast<double>(shape.places.cols());
  const Vector3 middle = shape.places.rowwise().sum() / count;
  const Vector3 mean = shape.displacements.rowwise().sum() / count;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vector3 moment = Vector3::Zero();
  for (Eigen::Index n = 0; n < shape.places.cols(); ++n) {
    const Vector3 arm = shape.places.col(n) - middle, way = shape.displacements.col(n);
    inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
    moment += arm.cross(way);
  }
  const Vector3 turn = inertia.inverse() * moment;
  const Eigen::Matrix3Xd arms = shape.places.colwise() - middle;
  const Eigen::Matrix3Xd bend = (shape.displacements - arms.colwise().cross(-turn)).colwise() - mean;
  return bend.colwise().squaredNorm().maxCoeff() <
         largest_bend * largest_bend * shape.displacements.colwise().squaredNorm().maxCoeff();
}

KindName kind_in(const BodyForm& form, const LocalShape& shape) {
  if (is_rigid(shape)) {
    return {.name = "rigid motion", .is_counted = true};
  }
  switch (form.kind) {
    case BodyForm::Kind::bar:
      return kind_in_bar(form, shape);
    case BodyForm::Kind::plate:
      return kind_in_plate(form, shape);
    case BodyForm::Kind::disc:
    case BodyForm::Kind::shell:
      return kind_in_round_body(form, shape);
    case BodyForm::Kind::other:
      break;
  }
  return {};
}

}  // namespace

int sign_changes(const std::vector<double>& values, double share) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  int changes = 0;
  double before = 0.0;
  for (const double value : values) {
    if (std::abs(value) > share * largest) {
      changes += value * before < 0.0 ? 1 : 0;
      before = value;
    }
  }
  return changes;
}

std::vector<std::string> kinds_of(std::span<const Vector3> nodes, const std::vector<std::vector<double>>& shapes) {
  const BodyForm form = form_of(nodes);
  LocalShape local;
  local.places.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    local.places.col(static_cast<Eigen::Index>(n)) = form.axes.transpose() * (nodes[n] - form.centre);
  }
  std::vector<std::string> kinds;
  std::map<std::string, int> counts;
  for (const std::vector<double>& shape : shapes) {
    const Eigen::Map<const Eigen::Matrix3Xd> displacements(shape.data(), 3, local.places.cols());
    local.displacements = form.axes.transpose() * displacements;
    const KindName kind = kind_in(form, local);
    const std::string name = kind.name + kind.ending;
    kinds.push_back(kind.is_counted ? fmt::format("{} {}{}", kind.name, ++counts[name], kind.ending) : name);
  }
  return kinds;
}

}  // namespace idiophone::mode_kinds

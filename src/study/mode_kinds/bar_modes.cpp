#include <algorithm>
#include <cmath>

#include "forms_of_modes.hpp"

namespace idiophone::mode_kinds {

namespace {

/// How the sections of a bar move: their means, and their turns about the bar.
struct SectionMotion {
  Vector3 mean = Vector3::Zero();  ///< sum of squares of the mean displacements along length, width and thickness
  double turn = 0.0;               ///< sum of squares of displacements by turning
  double all = 0.0;                ///< of all displacements
};

SectionMotion section_motion(const BodyForm& form, const LocalShape& shape) {
  constexpr Eigen::Index most_sections = 24;
  const Eigen::Index sections = std::clamp<Eigen::Index>(shape.places.cols() / 20, 4, most_sections);
  std::vector<std::vector<Eigen::Index>> nodes(static_cast<std::size_t>(sections));
  for (Eigen::Index n = 0; n < shape.places.cols(); ++n) {
    const double along = (shape.places(0, n) / form.extents[0] + 0.5) * static_cast<double>(sections);
    const auto section = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(along), 0, sections - 1);
    nodes[static_cast<std::size_t>(section)].push_back(n);
  }
  SectionMotion motion;
  for (const std::vector<Eigen::Index>& section : nodes) {
    if (section.empty()) {
      continue;
    }
    const auto count = static_cast<double>(section.size());
    Vector3 mean = Vector3::Zero(), middle = Vector3::Zero();
    for (const Eigen::Index n : section) {
      mean += shape.displacements.col(n) / count;
      middle += shape.places.col(n) / count;
    }
    double moment = 0.0, square = 0.0;
    for (const Eigen::Index n : section) {
      const Vector3 arm = shape.places.col(n) - middle, way = shape.displacements.col(n) - mean;
      moment += arm[1] * way[2] - arm[2] * way[1];
      square += arm[1] * arm[1] + arm[2] * arm[2];
      motion.all += shape.displacements.col(n).squaredNorm() / count;
    }
    motion.mean += mean.cwiseAbs2();
    motion.turn += square > 0.0 ? moment * moment / (square * count) : 0.0;
  }
  return motion;
}

}  // namespace

KindName kind_in_bar(const BodyForm& form, const LocalShape& shape) {
  constexpr double least_share = 0.5;
  const SectionMotion motion = section_motion(form, shape);
  const double most = std::max(motion.mean.maxCoeff(), motion.turn);
  if (most < least_share * motion.all) {
    return {};
  }
  if (motion.turn == most) {
    return {.name = "torsion", .is_counted = true};
  }
  if (motion.mean[0] == most) {
    return {.name = "longitudinal", .is_counted = true};
  }
  const bool is_flat = motion.mean[2] == most;
  return {
      .name = "bending",
      .is_counted = true,
      .ending = " along " + direction_name(form.axes.col(is_flat ? 2 : 1), is_flat ? "the thickness" : "the width")};
}

}  // namespace idiophone::mode_kinds

#include "body_form.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::mode_kinds {

namespace {

using Kind = BodyForm::Kind;

/// The box along some axes, which become ordered by its extents.
BodyForm box_along(std::span<const Vector3> nodes, const Eigen::Matrix3d& axes) {
  Eigen::AlignedBox3d box;
  for (const Vector3& node : nodes) {
    box.extend(axes.transpose() * node);
  }
  const Vector3 extents = box.sizes();
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::stable_sort(order, [&](int a, int b) { return extents[a] > 1.001 * extents[b]; });
  BodyForm form;
  form.centre = axes * box.center();
  for (int i = 0; i < 3; ++i) {
    form.axes.col(i) = axes.col(order.at(i));
    form.extents[i] = extents[order.at(i)];
  }
  return form;
}

/// Whether all slices of a body across the last axis of its box have round outlines.
bool has_round_slices(std::span<const Vector3> nodes, const BodyForm& box) {
  constexpr std::size_t slices = 4, sectors = 12;
  constexpr double least_ratio = 0.95;
  constexpr double rounding = 1e-6;  // nodes on a border all belong to the part above it
  std::array<std::array<double, sectors>, slices> radius{};
  for (const Vector3& node : nodes) {
    const Vector3 place = box.axes.transpose() * (node - box.centre);
    const double height = place[2] / std::max(box.extents[2], 1e-300) + 0.5;
    const double turn = std::atan2(place[1], place[0]) / (2.0 * std::numbers::pi) + 0.5;
    double& largest = radius.at(std::min(slices - 1, static_cast<std::size_t>(height * slices + rounding)))
                          .at(static_cast<std::size_t>(turn * sectors + rounding) % sectors);
    largest = std::max(largest, std::hypot(place[0], place[1]));
  }
  return std::ranges::all_of(radius, [](const auto& of_slice) {
    return std::ranges::min(of_slice) >= least_ratio * std::ranges::max(of_slice);
  });
}

/// The box with each of its axes last in turn, where the body is round about it.
std::vector<BodyForm> round_forms(std::span<const Vector3> nodes, const BodyForm& box) {
  std::vector<BodyForm> found;
  for (const int last : {0, 1, 2}) {
    BodyForm turned = box;
    for (int i = 0; i < 3; ++i) {
      turned.axes.col(i) = box.axes.col((last + 1 + i) % 3);
      turned.extents[i] = box.extents[(last + 1 + i) % 3];
    }
    if (has_round_slices(nodes, turned)) {
      turned.kind = turned.extents[2] <= 0.25 * turned.extents[0] ? Kind::disc : Kind::shell;
      found.push_back(turned);
    }
  }
  return found;
}

/// Whether there are nodes near the four corners of the box, seen along its last axis.
bool is_rectangular(std::span<const Vector3> nodes, const BodyForm& box) {
  const auto corner = [&](double i, double k) {
    return std::ranges::any_of(nodes, [&](const Vector3& node) {
      const Vector3 place = box.axes.transpose() * (node - box.centre);
      return std::hypot(place[0] - 0.5 * i * box.extents[0], place[1] - 0.5 * k * box.extents[1]) <
             0.05 * box.extents[1];
    });
  };
  return corner(-1, -1) && corner(-1, 1) && corner(1, -1) && corner(1, 1);
}

}  // namespace

BodyForm form_of(std::span<const Vector3> nodes) {
  const BodyForm along_coordinates = box_along(nodes, Eigen::Matrix3d::Identity());
  const BodyForm principal = box_along(nodes, dense::principal_axes(nodes));
  // The principal axes of a square or a disc are arbitrary.
  BodyForm box = along_coordinates.extents.prod() <= 1.001 * principal.extents.prod() ? along_coordinates : principal;
  for (const BodyForm& of_box : {along_coordinates, principal}) {
    const std::vector<BodyForm> round = round_forms(nodes, of_box);
    if (round.size() == 1) {
      return round.front();
    }
    if (round.size() > 1) {
      return box;  // a ball: no axis is its own
    }
  }
  if (box.extents[0] >= 3.5 * box.extents[1]) {
    box.kind = Kind::bar;
  } else if (box.extents[2] <= 0.2 * box.extents[1] && is_rectangular(nodes, box)) {
    box.kind = Kind::plate;
  }
  return box;
}

std::string direction_name(const Vector3& direction, const std::string& otherwise) {
  constexpr double aligned = 0.99;  // cosine
  Eigen::Index axis = 0;
  return direction.cwiseAbs().maxCoeff(&axis) > aligned ? std::string(1, "xyz"[axis]) : otherwise;
}

}  // namespace idiophone::mode_kinds

#include "idiophone/study/mode_kinds/mode_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "body_form.hpp"
#include "forms_of_modes.hpp"

namespace idiophone::mode_kinds {

namespace {

KindName kind_in(const BodyForm& form, const LocalShape& shape) {
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

#include "idiophone/study/mode_kinds/mode_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "body_form.hpp"
#include "forms_of_modes.hpp"
#include "idiophone/solids/eigenmodes/is_rigid_motion.hpp"

namespace idiophone::mode_kinds {

namespace {

KindName kind_in(const BodyForm& form, const LocalShape& shape) {
  if (eigenmodes::is_rigid_motion(shape.places, shape.displacements)) {
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

/// Names the modes of a body, one after another.
class Names {
 public:
  explicit Names(std::span<const Vector3> nodes) : form_(form_of(nodes)) {
    local_.places.resize(3, std::ssize(nodes));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      local_.places.col(static_cast<Eigen::Index>(n)) = form_.axes.transpose() * (nodes[n] - form_.centre);
    }
  }

  /// The kind of the next mode; empty where it has none.
  /// @param shape  [3 x nodes]
  std::string next(std::span<const double> shape) {
    const Eigen::Map<const Eigen::Matrix3Xd> displacements(shape.data(), 3, local_.places.cols());
    local_.displacements = form_.axes.transpose() * displacements;
    const KindName kind = kind_in(form_, local_);
    const std::string name = kind.name + kind.ending;
    return kind.is_counted ? fmt::format("{} {}{}", kind.name, ++counts_[name], kind.ending) : name;
  }

 private:
  BodyForm form_;
  LocalShape local_;
  std::map<std::string, int> counts_;  // of names so far
};

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

bool is_round(std::span<const Vector3> nodes) {
  const BodyForm::Kind kind = form_of(nodes).kind;
  return kind == BodyForm::Kind::disc || kind == BodyForm::Kind::shell;
}

std::vector<std::string> kinds_of(std::span<const Vector3> nodes, const std::vector<std::vector<double>>& shapes) {
  Names names(nodes);
  std::vector<std::string> kinds;
  std::ranges::transform(shapes, std::back_inserter(kinds), [&](const auto& shape) { return names.next(shape); });
  return kinds;
}

std::vector<std::string> kinds_of_assembly(std::span<const JoinedBody> bodies, bool is_one_piece,
                                           const std::vector<std::vector<double>>& shapes,
                                           std::span<const std::vector<double>> kinetic_shares) {
  constexpr double nearly_all = 0.9;
  std::vector<Vector3> nodes;
  std::vector<Names> of_bodies;
  std::vector<std::size_t> begins;
  for (const JoinedBody& body : bodies) {
    begins.push_back(3 * nodes.size());
    nodes.insert(nodes.end(), body.nodes.begin(), body.nodes.end());
    of_bodies.emplace_back(body.nodes);
  }
  Names of_all(nodes);
  const auto in_one_body = [&](std::size_t mode) -> std::string {
    const auto most = std::ranges::max_element(kinetic_shares[mode]);
    if (*most <= nearly_all) {
      return {};
    }
    const std::size_t b = most - kinetic_shares[mode].begin();
    const std::string kind = of_bodies[b].next(std::span(shapes[mode]).subspan(begins[b], 3 * bodies[b].nodes.size()));
    return kind.empty() ? kind : fmt::format("{}: {}", bodies[b].name, kind);
  };
  std::vector<std::string> kinds;
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    std::string& kind = kinds.emplace_back(is_one_piece ? of_all.next(shapes[mode]) : std::string());
    if (kind.empty()) {
      kind = in_one_body(mode);
    }
  }
  return kinds;
}

}  // namespace idiophone::mode_kinds

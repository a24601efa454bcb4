#include "tracked_modes.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/study/fitting/recognised_modes.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::fitting {

namespace {

constexpr int more_modes = 8;  // above the highest to follow

}  // namespace

scene::Solids body_of(const scene::Scene& scene, const std::string& body) {
  scene::refuse_joints(scene, "tune");
  return scene::Solids(scene).alone(scene::find_body(scene.bodies, body));
}

bool are_enough(const ModeShapes& lowest, int highest, double up_to) {
  return std::ssize(lowest.frequencies) >= highest + more_modes && lowest.frequencies.back() > up_to;
}

ModeShapes shapes_up_to(int highest, const scene::Solids& body, eigenmodes::MassMatrix mass, double up_to) {
  ModeShapes lowest = mode_shapes(body, {.count = highest + more_modes, .mass = mass});
  return are_enough(lowest, highest, up_to) ? lowest : mode_shapes(body, {.up_to = up_to, .mass = mass});
}

TrackedModes follow(const TrackedModes& known, ModeShapes body) {
  const RecognisedModes recognised = recognise(similarities(known.body, known.modes, body));
  TrackedModes found{known.numbers, {}, std::move(body)};
  for (std::size_t i = 0; i < known.modes.size(); ++i) {
    if (!recognised.modes[i]) {
      throw std::runtime_error(
          fmt::format("mode {} of the start can't be recognised: the most similar shape has a modal assurance "
                      "criterion of {:.2f}; choose narrower bounds",
                      known.numbers[i], recognised.likeness[i]));
    }
    found.modes.push_back(static_cast<int>(*recognised.modes[i]));
  }
  return found;
}

Eigen::VectorXd cents_above(const Target& target, const TrackedModes& tracked) {
  Eigen::VectorXd all(target.values.size());
  for (std::size_t i = 0; i < target.values.size(); ++i) {
    all[static_cast<Eigen::Index>(i)] = partials::cents(tracked.body.frequencies[tracked.modes[i]], target.values[i]);
  }
  return all;
}

Eigen::VectorXd errors(const Target& target, const Eigen::VectorXd& cents) {
  return target.are_ratios ? Eigen::VectorXd(cents.array() - cents[0]) : cents;
}

}  // namespace idiophone::fitting

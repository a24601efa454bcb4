#pragma once
// Modes that are recognised by their shapes while a body changes.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/study/fitting/target.hpp"
#include "mode_shapes.hpp"

namespace idiophone::fitting {

/// A body, and which of its modes are those to follow.
struct TrackedModes {
  std::vector<int> numbers;  ///< of the modes at the start, from 1 on, in the target's order
  std::vector<int> modes;    ///< where they are now, from 0 on
  ModeShapes body;
};

/// The sections of a scene that the modes of one of its bodies need.
/// @param body  its name; empty for the first
/// @throws std::runtime_error for a name that no body has
[[nodiscard]] scene::Solids body_of(const scene::Scene& scene, const std::string& body);

/// Whether these are the modes up to the highest one to follow, and some more, because their order may change.
/// @param highest  its number, from 1 on
/// @param up_to    Hz; all modes up to there are among them
[[nodiscard]] bool are_enough(const ModeShapes& lowest, int highest, double up_to);

/// The modes of a body up to the highest one to follow, and some more.
/// @param highest  its number, from 1 on
/// @param up_to    Hz; all modes up to there are among them
/// @throws what mode_shapes() throws
[[nodiscard]] ModeShapes shapes_up_to(int highest, const scene::Solids& body, eigenmodes::MassMatrix mass,
                                      double up_to = 0.0);

/// Recognises modes by the shapes that they have on a similar body.
/// @throws std::runtime_error where one of them is no longer there
[[nodiscard]] TrackedModes follow(const TrackedModes& known, ModeShapes body);

/// Cents of each of the target's modes above its value. [values of the target]
[[nodiscard]] Eigen::VectorXd cents_above(const Target& target, const TrackedModes& tracked);

/// The errors of modes: their cents; of ratios those above the first mode's, whose own are 0. [modes]
[[nodiscard]] Eigen::VectorXd errors(const Target& target, const Eigen::VectorXd& cents);

}  // namespace idiophone::fitting

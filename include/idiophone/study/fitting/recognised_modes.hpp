#pragma once
// Which mode of a changed body each mode of the body before is.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone::fitting {

/// Modes that were found again.
struct RecognisedModes {
  std::vector<std::optional<std::size_t>> modes;  ///< [known] places among the others; none of a mode that is lost
  std::vector<double> likeness;                   ///< [known] of the most similar shape that no other mode has
};

/// Gives each known mode another one, one to one, the most similar pair first. Shapes that are less than half alike are
/// not of one mode.
/// @param likeness  modal assurance criteria, [known x others] (Allemang and Brown 1982)
[[nodiscard]] RecognisedModes recognise(Eigen::MatrixXd likeness);

}  // namespace idiophone::fitting

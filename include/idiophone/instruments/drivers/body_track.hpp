#pragma once
// Where a body of a result is over time.

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::drivers {

/// A body that a result may strike.
struct StruckBody {
  std::string name;               ///< as in the deck of the run
  std::optional<Vector3> centre;  ///< of mass, undeformed, m; where the run has it first if empty
};

/// From the coordinates of the undeformed body to where it is at a time, s. After the last row, it stays.
using BodyTrack = std::function<Eigen::Isometry3d(double time)>;

/// The rigid motion of these bodies, by the channels centre_of_mass and orientation of a result, between whose rows it
/// is even.
/// @return [bodies]; empty for bodies that the run does not have
/// @throws std::runtime_error when the result can't be read, is damaged, or has no rows
[[nodiscard]] std::vector<BodyTrack> body_tracks(const std::filesystem::path& result,
                                                 const std::vector<StruckBody>& bodies);

}  // namespace idiophone::drivers

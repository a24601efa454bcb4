#pragma once
// The rigid motion of a body by the rows of a result.

#include "idiophone/instruments/drivers/body_track.hpp"
#include "motion_rows.hpp"

namespace idiophone::drivers {

class RigidTrack {
 public:
  /// @throws std::runtime_error when the result has no rows; std::invalid_argument when it does not have the body
  RigidTrack(const results::SeriesReader& reader, const StruckBody& body);

  /// As BodyTrack.
  [[nodiscard]] Eigen::Isometry3d at(double time) const;

 private:
  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t row) const;

  VectorChannel positions_, orientations_;
  Vector3 centre_;
};

}  // namespace idiophone::drivers

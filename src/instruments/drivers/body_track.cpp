#include "idiophone/instruments/drivers/body_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "rigid_track.hpp"

namespace idiophone::drivers {

RigidTrack::RigidTrack(const results::SeriesReader& reader, const StruckBody& body)
    : positions_(reader, fmt::format("motion/{}/centre_of_mass", body.name)),
      orientations_(reader, fmt::format("motion/{}/orientation", body.name)) {
  if (positions_.rows() == 0 || orientations_.rows() == 0) {
    throw std::runtime_error(
        fmt::format("the result has no motion of body {}; set output.motion_per_second", body.name));
  }
  centre_ = body.centre.value_or(positions_.vector(0));
}

Eigen::Isometry3d RigidTrack::at(double time) const {
  const std::size_t last = positions_.rows() - 1;
  const double place = std::clamp(time * positions_.rate, 0.0, static_cast<double>(last));
  const auto row = static_cast<std::size_t>(place);
  const std::size_t next = std::min(row + 1, last);
  const double share = place - static_cast<double>(row);
  const Vector3 position = (1.0 - share) * positions_.vector(row) + share * positions_.vector(next);
  return Eigen::Translation3d(position) * orientation(row).slerp(share, orientation(next)) *
         Eigen::Translation3d(-centre_);
}

Eigen::Quaterniond RigidTrack::orientation(std::size_t row) const {
  const double* wxyz = &orientations_.values[4 * std::min(row, orientations_.rows() - 1)];
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
}

std::vector<BodyTrack> body_tracks(const std::filesystem::path& result, const std::vector<StruckBody>& bodies) {
  const results::SeriesReader reader(result);
  std::vector<BodyTrack> tracks;
  for (const StruckBody& body : bodies) {
    const std::string path = fmt::format("/motion/{}/centre_of_mass", body.name);
    BodyTrack& track = tracks.emplace_back();
    if (std::ranges::find(reader.all(), path, &spectra::Series::path) != reader.all().end()) {
      track = [rigid = std::make_shared<const RigidTrack>(reader, body)](double time) { return rigid->at(time); };
    }
  }
  return tracks;
}

}  // namespace idiophone::drivers

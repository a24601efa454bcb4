#pragma once
// How bodies move as a whole, for the listeners that are attached to them.

#include <mpi.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/propagation/shared_positions.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

/// Each body's frame at any audio sample: its centre and rotation, from the positions of its surface (weighted by
/// area). An update at audio sample k n, n the interval, sends the positions to all ranks while the computation goes
/// on. From the two updates before, the frame is predicted for sample (k + 1) n, as if the body kept its velocity and
/// its angular velocity; until then the frame goes there on a cubic curve. So a steady motion is exact, and after a
/// blow the frame is late by two intervals at most. Positions and velocities are continuous.
class BodyFrames {
 public:
  /// Collective.
  /// @param acoustics  whose bodies give the initial velocities; bodies it does not have begin at rest
  BodyFrames(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, MPI_Comm communicator);

  /// Whether any listener is attached to a body.
  [[nodiscard]] static bool needed(const scene::Acoustics& acoustics);

  /// Whether update() is to be called at an audio sample.
  [[nodiscard]] bool due(std::int64_t sample) const { return sample >= 0 && sample % interval_ == 0; }

  /// Waits until all ranks have begun the previous update, which was an interval ago. Collective.
  void update(std::int64_t sample, const surface::SurfaceMotion& motion);

  /// A place that is carried by a body.
  struct Carrier {
    Vector3 reference;         ///< undeformed centre, m
    Vector3 centre;            ///< m
    Vector3 velocity;          ///< of the centre, m/s
    Eigen::Matrix3d turn;      ///< rotation since the undeformed body
    Vector3 angular_velocity;  ///< rad/s

    [[nodiscard]] Vector3 position(const Vector3& at_rest) const { return centre + turn * (at_rest - reference); }
    [[nodiscard]] Vector3 velocity_at(const Vector3& position) const {
      return velocity + angular_velocity.cross(position - centre);
    }
  };
  /// Of the body of a name, at an audio sample.
  [[nodiscard]] Carrier at(const std::string& body, std::int64_t sample) const;

  /// The state at this moment. Ends the update under way, which changes no later frame. Collective.
  void archive(parallel::Archive& archive);

 private:
  /// A body's position at one time.
  struct Place {
    Vector3 centre = Vector3::Zero();  ///< m
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  };
  /// And how it moves.
  struct Frame {
    Place place;
    Vector3 velocity = Vector3::Zero();          ///< m/s
    Vector3 angular_velocity = Vector3::Zero();  ///< rad/s
  };
  struct Body {
    std::size_t first, end;  ///< surface vertices, global numbers
    Vector3 reference;       ///< centre, m
    Place before, last;      ///< at the two updates before the present one
    Frame from, to;          ///< at the present update and at the next one
  };
  [[nodiscard]] static Frame moved(const Frame& frame, double time);
  [[nodiscard]] static Frame between(const Body& body, double interval, double time);
  [[nodiscard]] Place measured(const Body& body) const;
  [[nodiscard]] double seconds() const { return static_cast<double>(interval_) / rate_; }
  void finish();

  double rate_;            ///< audio samples per second
  std::int64_t interval_;  ///< audio samples
  SharedPositions shared_;
  std::vector<std::string> names_;  ///< [bodies]
  std::vector<double> weight_;      ///< [vertices] area, m2
  std::vector<float> rest_;         ///< [3 x vertices] undeformed, m
  std::vector<float> positions_;    ///< [3 x vertices] at the update before, m
  std::vector<Body> bodies_;
  std::int64_t begin_;  ///< audio sample of the present update
  bool updating_ = false;
};

}  // namespace idiophone::propagation

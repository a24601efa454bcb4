#pragma once
// What is written down of the motion besides the sound: energies and momenta at the motion rate, frames at the frame
// rate. They are kept until the end of the block, then summed over the ranks and written.

#include <mpi.h>

#include <vector>

#include "idiophone/motion/measure.hpp"
#include "idiophone/store/result_file.hpp"
#include "preparation.hpp"

namespace idiophone::app {

/// A body's motion in plain numbers, from sums over all ranks.
struct BodyMotion {
  Vector3 centre;            ///< of mass, m
  Vector3 velocity;          ///< of the centre, m/s
  Vector3 angular_momentum;  ///< about the centre, kg m2/s
  double kinetic = 0.0;      ///< energy, J
  double elastic = 0.0;      ///< energy, J
};

/// All bodies at one moment.
struct Observation {
  std::vector<BodyMotion> bodies;
  double work = 0.0;           ///< done so far by pulses and driven groups, J
  double gravitational = 0.0;  ///< potential energy against the origin, J

  /// Kinetic, elastic and gravitational energy, J; NaN where the motion is not finite.
  [[nodiscard]] double energy() const;
};

class Observer {
 public:
  Observer(const Preparation& ready, MPI_Comm communicator);

  /// Declares the series and meshes of a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// Notes what is due at an audio sample. No communication.
  void note(std::int64_t sample, motion::Motion& motion);

  /// Writes all notes. Collective, at the end of a block.
  void write(store::ResultFile& result);

  /// The bodies now, on rank 0. Collective.
  [[nodiscard]] Observation observe(motion::Motion& motion) const;

 private:
  struct Frame {
    double time;
    std::vector<std::vector<double>> displacement;  ///< [bodies][3 x owned nodes], m
  };
  [[nodiscard]] std::vector<std::int64_t> words(motion::Motion& motion) const;
  [[nodiscard]] std::size_t words_per_row() const;
  [[nodiscard]] Observation observation(std::span<const std::int64_t> row) const;
  [[nodiscard]] Frame frame(double time, const motion::Motion& motion) const;

  const Preparation& ready_;
  MPI_Comm communicator_;
  std::int64_t motion_stride_;             ///< audio samples between rows of the motion series; 0 for none
  std::vector<store::Rows> node_rows_;     ///< [bodies] numbered within the body
  std::vector<store::Rows> element_rows_;  ///< [bodies] owned elements, likewise
  std::vector<std::int64_t> notes_;        ///< [words per row x rows]
  std::vector<Frame> frames_;
};

}  // namespace idiophone::app

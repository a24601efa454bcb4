#pragma once
// Bodies of finite elements that are moved step by step, and their surfaces, low-passed to the audio rate (paper,
// sections 3.1 and 3.2).

#include <mpi.h>

#include <memory>
#include <optional>
#include <string>

#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "idiophone/run/bodies/air_coupling.hpp"
#include "idiophone/run/bodies/body_channels.hpp"
#include "idiophone/run/bodies/bolt_watch.hpp"
#include "idiophone/run/bodies/contact_channels.hpp"
#include "idiophone/run/bodies/fracture_channels.hpp"
#include "idiophone/run/bodies/gauge_channels.hpp"
#include "idiophone/run/bodies/load_channels.hpp"
#include "idiophone/run/bodies/source.hpp"
#include "idiophone/run/bodies/stability_watch.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

/// Audio samples of sound that a scene asks for: at least one.
[[nodiscard]] std::int64_t sound_samples(const scene::Scene& scene);

class BodySurfaces;

class FiniteElementSource : public Source {
 public:
  /// Collective.
  /// @param ready, stages  must outlive this object
  /// @param accelerator    see motion::Motion
  /// @throws std::runtime_error where an element is inverted or PETSc refuses an option; see motion::Motion
  FiniteElementSource(const Preparation& ready, parallel::Stages& stages, MPI_Comm communicator,
                      accelerator::Accelerator* accelerator = nullptr);

  ~FiniteElementSource() override;
  FiniteElementSource(const FiniteElementSource&) = delete;
  FiniteElementSource& operator=(const FiniteElementSource&) = delete;
  FiniteElementSource(FiniteElementSource&&) = delete;
  FiniteElementSource& operator=(FiniteElementSource&&) = delete;

  [[nodiscard]] std::int64_t first_sample() const override;
  void couple(propagation::AirLoad& air) override;

  /// From now on, the surface is read after each so many steps, not after Preparation::steps_per_read. The motion stays
  /// right and the sound becomes wrong: to measure times.
  void read_after(int steps) { steps_per_read_ = steps; }

  void start(surface::SurfaceMotion& motion) override;
  void advance(surface::SurfaceMotion& motion) override;
  [[nodiscard]] std::vector<ChannelGroup*> channels() override {
    return {&body_channels_, &contact_channels_, &load_channels_, &gauge_channels_, &fracture_channels_};
  }
  /// Throws when the motion is unstable. Warns of modal bodies that vibrate too far for their modes, and of bolts that
  /// lose their preload.
  void check() override;
  void archive(parallel::Archive& archive) override;
  /// How far bodies broke, what bolts lost of their preload, and how deeply bodies penetrated each other.
  void report() const override;

  [[nodiscard]] const motion::Motion& motion() const { return motion_; }
  /// All bodies now, on rank 0; others get an empty one. Collective.
  [[nodiscard]] Observation observe_now() { return observe(ready_, motion_, communicator_); }

  /// States of all local nodes, of which the owned ones are up to date.
  [[nodiscard]] const std::vector<solid::NodeState>& node_states();

 private:
  void advance_motion_to(std::int64_t end);  ///< a step's number
  void note_motion();
  /// Deepest penetration of a contact so far on any rank, m. Collective.
  [[nodiscard]] double deepest(std::size_t contact) const;
  /// Warns of partners that overlap at the start. Collective.
  /// @throws std::runtime_error where their contact pressure exceeds Young's modulus of the softer one
  void check_overlaps() const;
  void report_fracture() const;
  void warn_of_vibrations();
  /// What is wrong with a modal body that vibrates more than its model is right for; empty where nothing is.
  /// Collective.
  [[nodiscard]] std::string too_large_vibration(std::size_t body) const;  ///< of a model for small vibrations
  [[nodiscard]] std::string too_large_rotation(std::size_t body) const;   ///< of one for large ones

  const Preparation& ready_;
  int steps_per_read_;
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  int rank_;
  motion::Motion motion_;
  std::unique_ptr<BodySurfaces> surfaces_;
  std::optional<AirCoupling> air_;
  StabilityWatch stability_;
  BoltWatch bolts_;
  std::vector<bool> warned_;  ///< [bodies] of their vibration
  BodyChannels body_channels_;
  ContactChannels contact_channels_;
  LoadChannels load_channels_;
  GaugeChannels gauge_channels_;
  FractureChannels fracture_channels_;
  std::int64_t sample_ = 0;  ///< audio samples that the motion has done
};

}  // namespace idiophone::bodies

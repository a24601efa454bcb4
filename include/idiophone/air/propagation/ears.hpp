#pragma once
// All listeners of a scene, on every rank (paper, section 3.3).

#include <mpi.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/propagation/body_frames.hpp"
#include "idiophone/air/propagation/image_paths.hpp"
#include "idiophone/air/propagation/late_field.hpp"
#include "idiophone/air/propagation/line_of_sight.hpp"
#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/air/receivers/ear.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

/// Reads the responses of all heads.
/// @throws deck::DeckError with the place in the deck that names a file without any
void check_heads(const scene::Acoustics& acoustics);

class Ears {
 public:
  /// Sounds whose sum is that at a place, [this rank's share], in the model's unit; each is rounded by itself, so that
  /// the sum does not depend on who has them.
  using LocalSounds = std::array<double, 8>;
  /// What is emitted along a path: 0 is the direct one, then come the reflections.
  using EmissionOn = std::function<const surface::Emission&(std::size_t path)>;

  /// @param first      audio sample of the first emission that will be heard
  /// @param triangles  of this rank's surface
  Ears(const scene::Acoustics& acoustics, std::int64_t first, std::size_t triangles);

  /// The same by another radiation model than the scene's.
  Ears(const scene::Acoustics& acoustics, std::int64_t first, std::size_t triangles,
       std::unique_ptr<radiation::Model> model, const receivers::Spreading& spreading);

  /// From now on, these frames carry the attached listeners. Without them, listeners stand still. The frames must
  /// outlive this object.
  void attach(const BodyFrames& frames) { frames_ = &frames; }

  /// Radiates what the surface emitted at an audio sample to every receiver, by way of the floor or of the walls of the
  /// room as well. No communication.
  /// @param sight  visibility for each ear, and for reflections where it has them; null: everything is visible
  /// @param local_sounds  [ear_count()] what an ear hears instead, from all directions, with the floor's reflection;
  ///                      none where it hears the surface; empty: no ear has such a sound
  /// @param late_emission  what the late field of a room gets instead; null: the emission
  /// @throws std::runtime_error when a sound is not finite or too loud to be summed exactly, such an ear is a head, or
  ///         something is outside the room
  void hear(std::int64_t sample, const surface::Emission& emission, const LineOfSight* sight,
            std::span<const std::optional<LocalSounds>> local_sounds = {},
            const surface::Emission* late_emission = nullptr);

  /// The same where the emission differs from path to path, and the room has no late field. Everything may be anywhere.
  void hear(std::int64_t sample, const EmissionOn& emission_on);

  /// Where the paths to an ear end at an audio sample if they go straight: at the ear, then at its mirror images, m.
  [[nodiscard]] std::vector<Vector3> path_ends(std::int64_t sample, std::size_t ear) const;

  /// Where the ears are at an audio sample, [ear_count()], m.
  [[nodiscard]] std::vector<Vector3> positions(std::int64_t sample) const;

  /// As the radiation model asks for.
  [[nodiscard]] radiation::SelfOcclusion self_occlusion() const {
    return model_->shaded_by_own_body() ? radiation::SelfOcclusion::included : radiation::SelfOcclusion::excluded;
  }

  /// Audio samples before this one are final once everything emitted up to `sample` was heard.
  [[nodiscard]] std::int64_t final_before(std::int64_t sample) const;

  /// The model that the sounds are found by.
  [[nodiscard]] const radiation::Model& model() const { return *model_; }

  /// Takes the next `count` audio samples out, summed over the ranks; the first ever begin at audio sample 0. What
  /// comes before, the low-pass's lead, is dropped. Collective.
  /// @return [listeners][receivers x count] on rank 0, a sample's receivers side by side
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count, MPI_Comm communicator);

  /// Sound that has not arrived yet, the late field's, and the heads' state for each triangle. Collective.
  /// @param triangles  the rows that this rank's triangles are
  void archive(parallel::Archive& archive, const parallel::Rows& triangles);

  /// Microphones and heads.
  [[nodiscard]] std::size_t ear_count() const { return ears_.size(); }

 private:
  /// A microphone of a listener, or its head.
  struct Member {
    const scene::Listener* listener;
    const scene::Receiver* receiver;
    receivers::Ear ear;
  };
  /// A receiver at one moment, and its head's frame: rows to the front, to the left, up.
  struct Stand {
    radiation::ReceiverState receiver;
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  };
  void add(const scene::Listener& listener, const scene::Receiver& receiver, std::int64_t first, std::size_t triangles);
  [[nodiscard]] std::shared_ptr<const receivers::HeadResponses> find_head(const scene::Listener& listener) const;
  /// At the audio sample that is emitted.
  [[nodiscard]] Stand stand(std::int64_t sample, const Member& member) const;
  [[nodiscard]] static Stand mirrored(const Stand& stand, const ImagePath& path);
  void add_late_field(std::int64_t first);
  /// Of an emission and of the ears.
  void require_inside(std::int64_t sample, const surface::Emission& emission) const;
  /// Straight from the triangles.
  void hear_directly(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                     const LineOfSight* sight, std::size_t ear);
  /// By way of the floor or of the walls of a room.
  void hear_reflections(std::int64_t sample, const EmissionOn& emission_on, const Stand& stand,
                        const LineOfSight* sight, std::size_t ear);
  /// Along one propagation path, found in paths_ before: straight and around edges.
  void hear_along(std::int64_t sample, const surface::Emission& emission, const Stand& stand, const LineOfSight* sight,
                  std::size_t path, std::size_t ear);
  /// By a way around edges, after radiate(): a number of DiffractingEdges.
  void hear_around(std::int64_t sample, const surface::Emission& emission, const Stand& stand, const LineOfSight& sight,
                   std::size_t path, std::int64_t way, std::size_t ear);
  /// Along paths_, which belong to one propagation path: 0 is the direct one.
  void radiate(std::int64_t sample, const surface::Emission& emission, const Stand& stand, std::size_t path,
               receivers::Ear& ear);

  /// Sounds that are where the ear is.
  static_assert(std::tuple_size_v<LocalSounds> % lane_count == 0);
  void hear_here(std::int64_t sample, const LocalSounds& sounds, receivers::Ear& ear);

  scene::Acoustics acoustics_;
  const BodyFrames* frames_ = nullptr;
  radiation::Medium air_;
  std::unique_ptr<radiation::Model> model_;
  const receivers::Spreading& spreading_;
  std::vector<ImagePath> images_;
  std::vector<Member> ears_;  ///< of all listeners
  std::optional<LateField> late_;
  radiation::Paths paths_;
  radiation::Arrivals arrivals_;
  radiation::Paths bent_paths_;
  std::vector<receivers::WavesInTurn> edge_waves_;  ///< [triangles]
};

}  // namespace idiophone::propagation

#pragma once
// All listeners of a scene: each receiver has an accumulation buffer on every rank (paper, section 3.3).

#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "idiophone/listening/accumulation_buffer.hpp"
#include "idiophone/radiation/radiation.hpp"
#include "idiophone/scene/scene.hpp"
#include "line_of_sight.hpp"

namespace idiophone::app {

class Ears {
 public:
  /// @param first  audio sample of the first emission that will be heard
  Ears(const scene::Scene& scene, std::int64_t first);

  /// Radiates what the surface emitted at an audio sample to every receiver. No communication.
  /// @param sight  what each receiver sees, or null: all
  /// @throws std::runtime_error when a sound is not finite or too loud to be summed exactly
  void hear(std::int64_t sample, const surface::Emission& emission, const LineOfSight* sight);

  /// Where the receivers are, [receivers], m.
  [[nodiscard]] std::vector<Vector3> positions() const;

  /// Whether a body's triangles hide each other, by the model.
  [[nodiscard]] bool own_body_hides() const { return model_->shaded_by_own_body(); }

  /// Audio samples before this one are final once everything emitted up to `sample` was heard.
  [[nodiscard]] std::int64_t final_before(std::int64_t sample) const { return sample + 1 + spreading_.first(); }

  /// The model that the sounds are found by.
  [[nodiscard]] const radiation::Model& model() const { return *model_; }

  /// Drops entries before the audio sample 0, which only hold the low-pass's lead.
  void drop_lead();

  /// Takes the next `count` audio samples out, summed over the ranks. Collective.
  /// @return [listeners][receivers x count] on rank 0, a sample's receivers side by side
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count, MPI_Comm communicator);

  /// What is still on its way, summed over the ranks, as whole numbers on rank 0. Collective.
  /// @return [receivers][2 x entries] coarse and fine
  [[nodiscard]] std::vector<std::vector<std::int64_t>> pending(MPI_Comm communicator) const;

  /// Goes on from what `pending` gave when first() was `first`; give it to one rank, and nothing to
  /// others.
  void restore(std::int64_t first, const std::vector<std::vector<std::int64_t>>& pending);

  /// Audio sample that the next one taken belongs to; negative before the lead was dropped.
  [[nodiscard]] std::int64_t first() const { return buffers_.front().first(); }

  [[nodiscard]] std::size_t receiver_count() const { return receivers_.size(); }

 private:
  const scene::Scene& scene_;
  radiation::Air air_;
  std::unique_ptr<radiation::Model> model_;
  const listening::Spreading& spreading_;
  std::vector<radiation::Receiver> receivers_;          ///< of all listeners
  std::vector<listening::AccumulationBuffer> buffers_;  ///< [receivers]
  radiation::Paths paths_;
  radiation::Arrivals arrivals_;
};

}  // namespace idiophone::app

#pragma once
// The late field of a room: what arrives after more reflections than those that are computed one by one.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/air/receivers/filter_bank.hpp"
#include "idiophone/air/receivers/head_responses.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/spectra/convolver.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::propagation {

/// The sound that leaves in each of a few directions, by receivers there, is common to all ears. For each ear, noise
/// that decays follows it (docs/method/rooms.md). Rank 0 computes it, so its bits do not depend on the number of ranks.
class LateField {
 public:
  /// Who hears it.
  struct Listener {
    double directivity = 0.0;                              ///< as ReceiverState's
    std::shared_ptr<const receivers::HeadResponses> head;  ///< null for a microphone

    [[nodiscard]] std::size_t channels() const { return head ? 2 : 1; }
  };

  /// @param radiation  with a room
  /// @param first      audio sample of the first emission, with the spreading's first
  /// @param spreading  must outlive this object
  LateField(const scene::Radiation& radiation, const radiation::Medium& air, std::int64_t first,
            const receivers::Spreading& spreading, std::vector<Listener> listeners);

  /// Adds what leaves at an audio sample. No communication.
  /// @throws as AccumulationBuffer::add
  void hear(std::int64_t sample, const surface::Emission& emission, const radiation::Model& model);

  /// Removes the next `count` audio samples; the first ever begin at audio sample 0, as those of the ears. They are
  /// final when those of the ears are, or before. Collective.
  /// @return [channels of all listeners, one listener after the other][count] on rank 0, empty elsewhere
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count, MPI_Comm communicator);

  /// All that decides the future. Collective.
  void archive(parallel::Archive& archive);

 private:
  void make_convolvers();
  void forget();

  scene::Radiation radiation_;
  radiation::Medium air_;
  std::vector<Listener> listeners_;
  std::vector<radiation::ReceiverState> around_;  ///< [directions]
  radiation::Paths paths_;
  radiation::Arrivals arrivals_;
  receivers::FilterBank leaving_;                            ///< a channel for each direction
  std::vector<std::vector<spectra::Convolver>> convolvers_;  ///< [channels][directions], on rank 0 after the first use
  std::vector<double> past_;  ///< [samples][directions] that the convolvers remember, from a whole piece on
};

}  // namespace idiophone::propagation

#pragma once
// What a run is and what it took, as JSON: for /run of a result (docs/use/result_file.md) and for `check --json`.

#include <mpi.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/recording.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::loop {

/// A number as JSON; null if it is not finite.
[[nodiscard]] nlohmann::json number_or_null(double value);

/// Adds `order` if elements of this kind have several orders.
void add_order(nlohmann::json& facts, element::Type type);

/// Up to which frequencies (Hz) the mesh keeps the pitch of a body within 5 and within 50 cents by the rules of
/// docs/use/mesh_guide.md, where there are rules for the body. Call on rank 0.
[[nodiscard]] std::optional<std::pair<double, double>> pitch_limits(const bodies::Preparation& ready, std::size_t b);

/// Step, steps per sample and per read, sizes and masses. Call on rank 0.
[[nodiscard]] nlohmann::json size_facts(const bodies::Preparation& ready);

/// The same and the resolved deck, on rank 0; nothing elsewhere. Collective.
[[nodiscard]] nlohmann::json run_facts(const bodies::Preparation& ready, MPI_Comm communicator);

/// What `listen` hears: the recorded run, the surfaces, and the resolved deck for listening. On rank 0.
/// @param recording  what it says of the run and its bodies
/// @param surface    of the same bodies in the same order
/// @param deck       resolved
[[nodiscard]] nlohmann::json listening_facts(const surface::RecordingHeader& recording,
                                             const propagation::AudibleSurface& surface, const std::string& deck);

/// Elements, nodes, ghosts, neighbours, halo.
/// @param largest  of all ranks
[[nodiscard]] nlohmann::json part_facts(const mesh::PartSize& largest, motion::Halo halo);

/// The widest vectors that this program was built for, for example "AVX2".
[[nodiscard]] std::string instruction_set();

/// Collective. @throws std::runtime_error on all ranks if ranks have programs for different instruction sets
void require_one_instruction_set(const std::string& own, MPI_Comm communicator);

/// What a job computes with: ranks, instruction set, versions of the libraries.
/// @param first_sample  audio samples done before it
[[nodiscard]] nlohmann::json job_facts(std::int64_t first_sample, int ranks);

/// The largest part of a job's ranks. Collective.
[[nodiscard]] mesh::PartSize largest_part(const mesh::Part& part, MPI_Comm communicator);

/// The most main memory that ranks held, bytes.
struct MemoryPeaks {
  double root = 0.0;     ///< of rank 0, which prepares the run
  double largest = 0.0;  ///< of the other ranks; of rank 0 if it is alone
};

/// Collective.
[[nodiscard]] MemoryPeaks memory_peaks(MPI_Comm communicator);

/// What a job did that stopped in good order.
struct JobEnd {
  std::int64_t last_sample = 0;         ///< audio samples done
  std::optional<double> element_steps;  ///< elements times steps that the job did; none where nothing is computed
  double elapsed = 0.0;                 ///< wall clock, s
  double processor_time = 0.0;          ///< of this rank, s
  MemoryPeaks memory;
};

/// What is added to the facts of a job when it ends: samples, wall clock, processor time, elements per second, time of
/// each stage on this rank.
[[nodiscard]] nlohmann::json end_facts(const JobEnd& end, const parallel::Stages& stages);

}  // namespace idiophone::loop

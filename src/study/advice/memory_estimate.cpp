#include "idiophone/study/advice/memory_estimate.hpp"

#include "open_mpi_memory.hpp"

namespace idiophone::advice {

namespace {

// Bytes of the tables of docs/architecture.md for each of these.
constexpr double per_node = 24 + 4 + 64 + 32 + 24;  ///< position, number, state, force, mass
constexpr double per_owned_node = 16 + 112 + 120;   ///< place in files, a copy of the motion for its energies, PETSc
constexpr double per_ghost = 24;                    ///< owner, and what PETSc keeps of it
constexpr double per_triangle = 1000;               ///< displacements, low-pass, radiation
/// Code and buffers that are first used while it runs: with Open MPI 4, 28 to 33 MB were measured.
constexpr double of_run = 30e6 - saved_by_open_mpi;

}  // namespace

MemoryEstimate::MemoryEstimate(const bodies::Preparation& ready, const motion::Dynamics& dynamics, double program)
    : fixed_(program + of_run + static_cast<double>(ready.initial_state.displacement.size() * sizeof(double))) {
  for (std::size_t b = 0; b < ready.part.bodies.size(); ++b) {
    const mesh::BodyPart& body = ready.part.bodies[b];
    const auto elements = static_cast<double>(body.element_ids.size());
    const double in_part =
        sizeof(Index) * (1.0 + element::node_count(body.element)) + sizeof(char) + sizeof(double);  // the last: energy
    element_bytes_.push_back(in_part + (elements > 0 ? static_cast<double>(dynamics.model(b).bytes()) / elements : 0));
  }
}

double MemoryEstimate::of_bodies(const mesh::Part& part) const {
  double bytes = per_node * static_cast<double>(part.node_ids.size());
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    bytes += element_bytes_[b] * static_cast<double>(part.bodies[b].element_ids.size());
  }
  return bytes;
}

double MemoryEstimate::of(const mesh::Part& part) const {
  return fixed_ + of_bodies(part) + per_triangle * static_cast<double>(part.surface.size()) +
         per_owned_node * part.owned_nodes + per_ghost * static_cast<double>(part.ghost_rank.size());
}

}  // namespace idiophone::advice

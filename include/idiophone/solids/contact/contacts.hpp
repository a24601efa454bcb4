#pragma once
// All contacts of a scene, on this rank: which sides are near each other, and the forces between those that touch.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/messages.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/contact/contact_motion.hpp"
#include "idiophone/solids/contact/contact_surfaces.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::contact {

/// What becomes of the bonds of friction when forces are computed: after a step they stretch by dt times the slip
/// velocity; where the same state comes again, after a restart, they stay as they are.
enum class BondUpdate { stretch, keep };

class Contacts {
 public:
  /// Collective.
  /// @param step              dt, s
  /// @param steps_per_update  steps between two updates of the broad phase
  Contacts(const scene::Solids& solids, const mesh::Part& part, const ContactSurfaces& contact_surfaces, double step,
           int steps_per_update, MPI_Comm communicator);
  ~Contacts();
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;
  Contacts(Contacts&&) = delete;
  Contacts& operator=(Contacts&&) = delete;

  /// Whether compute_forces reads the states of all nodes of a contact's skins at a step: for the broad phase, which is
  /// left out while the partners are far away.
  [[nodiscard]] bool needs_all_states(std::int64_t step_number) const;

  /// Computes the forces at a step. Exchanges messages with the ranks that take part in the same contacts; no
  /// collective call.
  /// @param state  [local nodes]
  void compute_forces(std::int64_t step_number, std::span<const solid::NodeState> state, BondUpdate bonds);

  /// Adds the forces on this rank's nodes, N.
  void add_force(std::span<solid::NodeForce> force) const;

  /// Owned nodes that may touch until the next update of the broad phase: compute_forces reads no others' states until
  /// then. Local numbers; a node may occur more than once.
  [[nodiscard]] std::vector<Index> owned_near() const;

  /// Energy stored in a contact's overlaps and bonds now, J, on the one rank that reports it; 0 on the others.
  [[nodiscard]] double energy(std::size_t contact) const;

  /// Means over the steps between the two last updates of the broad phase: force and overlap in time, the others
  /// weighted by the force. On the one rank that reports the contact; all zero on the others.
  [[nodiscard]] const ContactMotion& motion(std::size_t contact) const;

  /// The contact as it is now, on the one rank that reports it; all zero on the others.
  [[nodiscard]] ContactMotion now(std::size_t contact) const;

  /// Deepest penetration that this rank has seen so far, m.
  [[nodiscard]] double deepest(std::size_t contact) const;

  /// Wall-clock time of compute_forces since the last call, s.
  [[nodiscard]] double take_seconds() { return std::exchange(seconds_, 0.0); }

  [[nodiscard]] std::size_t count() const { return pairs_.size(); }

  /// All that decides the future. After restoring, compute_forces is called with the state that belongs to it and
  /// BondUpdate::keep. Collective.
  /// @param nodes  the rows that this rank's owned nodes are
  void archive(parallel::Archive& archive, const parallel::Rows& nodes);

 private:
  struct Pair;
  void update_broad_phase(std::int64_t step_number, std::span<const solid::NodeState> state,
                          parallel::Messages& messages);
  void find_participations();
  void exchange_states(std::span<const solid::NodeState> state, parallel::Messages& messages);

  std::vector<std::unique_ptr<Pair>> pairs_;  ///< [contacts]
  std::vector<Pair*> shared_;                 ///< that may touch and of which other ranks have nodes there, too
  std::vector<Pair*> own_;                    ///< that may touch where only this rank has nodes
  MPI_Comm communicator_;
  int steps_per_update_;
  double seconds_ = 0.0;
};

}  // namespace idiophone::contact

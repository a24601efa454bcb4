#pragma once
// The node states of a contact, exchanged among the ranks that take part in it. All ranks that own skin nodes of the
// contact's bodies exchange their bounds at every update of the broad phase. While the two sides are near each other,
// the ranks with nodes there send these at every step to the others of them, and each computes the whole contact: so
// its bits do not depend on the partition. All messages go from rank to rank; no other rank waits for them.

#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "broad_phase.hpp"
#include "local_skin.hpp"
#include "side.hpp"

namespace idiophone::contact {

class NeighbourExchange {
 public:
  /// Collective.
  /// @param sides  one side, or two if both partners are bodies
  NeighbourExchange(std::vector<Side*> sides, const mesh::Part& part, MPI_Comm communicator);

  /// Exchanges where all ranks' nodes are, and from that finds the participants and their nodes, with their bonds.
  /// The positions of the participants' nodes are unknown until exchange_states.
  /// @param state  [local nodes]
  void update(std::span<const solid::NodeState> state, BroadPhase& broad_phase);

  /// Exchanges positions and velocities of all nodes that may touch.
  /// @param state  [local nodes]
  void exchange_states(std::span<const solid::NodeState> state);

  /// Whether this rank takes part, so that its sides are known.
  [[nodiscard]] bool participates() const { return participates_; }
  /// Whether this rank is the lowest participant: it reports the contact's motion and energy.
  [[nodiscard]] bool is_reporting_rank() const;

  /// Cells of a side whose nodes are all known, ascending.
  [[nodiscard]] std::vector<Index> known_cells(std::size_t side) const;
  /// Nodes of a side that this rank owns, ascending.
  [[nodiscard]] const std::vector<SkinNode>& owned(std::size_t side) const { return local_[side].owned; }
  /// Those of them that may touch.
  [[nodiscard]] const std::vector<SkinNode>& owned_near(std::size_t side) const { return sent_[side]; }

 private:
  /// Another rank that owns skin nodes.
  struct Peer {
    int rank;
    Bounds bounds;
    bool participates = false;
    std::array<std::vector<Index>, 2> nodes;  ///< that it sends, as places in the skins
  };
  [[nodiscard]] bool owns_nodes() const;
  [[nodiscard]] Bounds local_bounds(std::span<const solid::NodeState> state);
  void exchange_bounds(const Bounds& own);
  void exchange_nodes();
  void receive_nodes(const std::vector<double>& message, Peer& peer);

  std::vector<Side*> sides_;
  MPI_Comm communicator_;
  int rank_;
  bool participates_ = false;
  std::vector<LocalSkin> local_;             ///< [sides]
  std::vector<std::vector<SkinNode>> sent_;  ///< [sides] owned nodes that may touch, ascending
  std::vector<Peer> peers_;
};

}  // namespace idiophone::contact

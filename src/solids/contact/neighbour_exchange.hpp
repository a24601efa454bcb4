#pragma once
// What the ranks of one contact exchange. All ranks that own skin nodes of the contact's bodies exchange their bounds
// at every update of the broad phase. While the two sides are near each other, the ranks with nodes there take part: at
// every step they exchange the states of these nodes, each computes a portion of the overlaps, and they exchange these.
// Each then knows all overlaps, in an order that does not depend on the partition, and from them computes the forces.
// All messages go from rank to rank; no other rank waits for them.
//
// Every exchange is a function that sends and one that receives, so that a rank can send for all contacts first.

#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "broad_phase.hpp"
#include "idiophone/foundation/parallel/messages.hpp"
#include "interaction.hpp"
#include "local_skin.hpp"
#include "side.hpp"

namespace idiophone::contact {

class NeighbourExchange {
 public:
  /// Collective.
  /// @param sides  one side, or two if the partners are two bodies
  NeighbourExchange(std::vector<Side*> sides, const mesh::Part& part, MPI_Comm communicator);

  /// First part of an update: sends where this rank's nodes are.
  /// @param state  [local nodes]
  void send_bounds(std::span<const solid::NodeState> state, parallel::Messages& messages);

  /// Second part: receives where all nodes are, and from that finds the participants. Sends them this rank's nodes that
  /// may touch, with their bonds.
  void receive_bounds(BroadPhase& broad_phase, parallel::Messages& messages);

  /// Third part: receives the participants' nodes. Their positions are unknown until receive_states.
  void receive_nodes(const parallel::Messages& messages);

  /// Leaves out all nodes of a side that no cell of a list has; the same list on all ranks that take part.
  void keep_nodes(std::size_t side, const std::vector<Index>& cells);

  /// Sends positions and velocities of the nodes that may touch.
  /// @param state  [local nodes]
  void send_states(std::span<const solid::NodeState> state, parallel::Messages& messages);
  void receive_states(const parallel::Messages& messages);

  /// The portion of the overlaps that this rank computes.
  /// @param pairs  of cells that may overlap; if they are few, each rank computes all of them
  [[nodiscard]] Portion portion(std::size_t pairs) const;

  /// Sends this rank's portion of the overlaps, if there are others.
  void send_overlaps(const Portion& portion, const Overlaps& overlaps, parallel::Messages& messages) const;
  /// Receives the others' and puts all in order.
  void receive_overlaps(const Portion& portion, Overlaps& overlaps, const parallel::Messages& messages) const;

  /// This rank and all others take no part until the next update.
  void withdraw();

  /// Whether this rank takes part, so that its sides are known.
  [[nodiscard]] bool participates() const { return participates_; }
  /// Whether other ranks do, too.
  [[nodiscard]] bool is_shared() const;
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
  void send_nodes(parallel::Messages& messages) const;
  void take_nodes(std::vector<double> message, Peer& peer);
  /// Peers that take part; none if this rank does not.
  [[nodiscard]] std::vector<const Peer*> other_participants() const;

  std::vector<Side*> sides_;
  int rank_;
  bool participates_ = false;
  Bounds own_;
  std::vector<LocalSkin> local_;             ///< [sides]
  std::vector<std::vector<SkinNode>> sent_;  ///< [sides] owned nodes that may touch, ascending
  std::vector<Peer> peers_;                  ///< ascending
};

}  // namespace idiophone::contact

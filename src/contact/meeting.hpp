#pragma once
// Who takes part in a contact now, and how its positions get there. All ranks that own skin nodes of a contact's bodies
// tell each other at a fixed rhythm where these are. While the two sides are near each other, the ranks with nodes
// there send them at every step to the others of them, and each works out the whole contact: so its bits do not depend
// on how the bodies are parted. All of it goes from rank to rank; nobody waits for those who have no part in it.

#include <mpi.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "idiophone/mesh/part.hpp"
#include "idiophone/solid/node.hpp"
#include "side.hpp"

namespace idiophone::contact {

class Meeting {
 public:
  /// Collective.
  /// @param second    null where the partner is a shape
  /// @param shape     null where the partner is a body
  /// @param interval  time between two calls of look, s
  Meeting(Side& first, Side* second, const RigidShape* shape, const mesh::Part& part, double interval,
          MPI_Comm communicator);

  /// Finds out who is near and tells these which nodes to expect, and their bonds; then follow() is due.
  void look(const solid::NodeState* state);

  /// Positions and velocities of all nodes that are near, on every rank that has some.
  void follow(const solid::NodeState* state);

  /// Whether this rank takes part, so that its sides are known.
  [[nodiscard]] bool near() const { return near_; }
  /// Whether this rank is the first of those that take part: it speaks for the contact.
  [[nodiscard]] bool speaks() const;
  /// Cells whose nodes are all known; or parts of the shape. [2]
  [[nodiscard]] const std::vector<Index>& cells(std::size_t side) const { return cells_.at(side); }
  /// Distance within which cells may meet until the next look, m.
  [[nodiscard]] double margin() const { return margin_; }
  /// A node of a skin that this rank has: its place in the skin and its local number.
  struct SkinNode {
    Index place;
    Index node;
  };
  /// Those that this rank owns, ascending.
  [[nodiscard]] const std::vector<SkinNode>& own(std::size_t side) const { return own_.at(side); }
  /// Those of them that are near.
  [[nodiscard]] const std::vector<SkinNode>& own_near(std::size_t side) const { return sent_.at(side); }

 private:
  /// What a rank says of its part of both sides.
  struct Whereabouts {
    std::array<Box, 2> boxes;
    double speed = 0.0;  ///< largest of its nodes, m/s
  };
  struct Peer {
    int rank;
    Whereabouts whereabouts;
    bool near = false;
    std::array<std::vector<Index>, 2> nodes;  ///< that it sends, as places in the skins
  };
  void find_local(std::size_t side, const std::vector<std::pair<Index, Index>>& local, const mesh::Part& part);
  [[nodiscard]] Whereabouts whereabouts(const solid::NodeState* state);
  void place(std::size_t side, const SkinNode& node, const solid::NodeState* state);
  void tell(const Whereabouts& mine);
  [[nodiscard]] bool may_meet(const Whereabouts& part, const Whereabouts& whole) const;
  [[nodiscard]] bool near_shape(const Box& box) const;
  [[nodiscard]] bool near_part(const Box& box, std::size_t part) const;
  void choose_nodes(const Whereabouts& whole);
  [[nodiscard]] std::vector<std::uint8_t> sides_beyond(std::size_t side, const Box& zone) const;
  void announce();
  void gather_cells(const Whereabouts& whole);
  [[nodiscard]] Side& side(std::size_t which) const { return *(which == 0 ? first_ : second_); }

  Side* first_;
  Side* second_;
  const RigidShape* shape_;
  std::size_t sides_;
  MPI_Comm communicator_;
  int rank_ = 0;
  double interval_;
  double reach_;         ///< least margin, m
  Box shape_box_;        ///< around all of the shape
  double margin_ = 0.0;  ///< m
  bool near_ = false;
  std::array<std::vector<SkinNode>, 2> own_;      ///< ascending
  std::array<std::vector<SkinNode>, 2> here_;     ///< own nodes and the ghosts of their cells, ascending
  std::array<std::vector<Index>, 2> cells_here_;  ///< with an own node
  std::array<std::vector<SkinNode>, 2> sent_;     ///< own nodes that are near, ascending
  std::array<std::vector<Index>, 2> cells_;
  std::vector<Peer> peers_;  ///< the other ranks with own nodes
};

}  // namespace idiophone::contact

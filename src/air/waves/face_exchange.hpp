#pragma once
// The pressures at the faces of a subdomain go to its neighbours, and theirs come.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/division.hpp"

namespace idiophone::waves {

/// One message to each neighbour and one from it: the cells of the face that both have in common, then the nodes of
/// these cells. Ghost cells at edges and corners are not sent, as nothing flows through them.
class FaceExchange {
 public:
  /// Collective, as is the end.
  /// @param communicator  of as many ranks as the division has
  FaceExchange(const Division& division, MPI_Comm communicator);
  ~FaceExchange();
  FaceExchange(const FaceExchange&) = delete;
  FaceExchange& operator=(const FaceExchange&) = delete;
  FaceExchange(FaceExchange&&) = delete;
  FaceExchange& operator=(FaceExchange&&) = delete;

  /// The nodes that are exchanged from now on.
  void set_nodes(const CutCells& cut_cells);

  /// Places in [cells, then nodes] of what is sent, each once, and of what is received.
  [[nodiscard]] std::vector<Index> own_places() const;
  [[nodiscard]] std::vector<Index> ghost_places() const;

  /// Begins to send; waits for nobody.
  /// @param of_cell   of_cell(number of a cell in the subdomain), Pa
  /// @param of_nodes  [nodes] Pa
  template <class OfCell>
  void start(const OfCell& of_cell, std::span<const float> of_nodes) {
    for (Neighbour& neighbour : neighbours_) {
      auto* value = neighbour.sent.data();
      for_each_row(neighbour.own_cells, [&](Index first, int length) {
        for (int i = 0; i < length; ++i) {
          *value++ = of_cell(first + i);
        }
      });
      for (const Index node : neighbour.own_nodes) {
        *value++ = of_nodes[node];
      }
    }
    send();
  }

  /// Waits for the messages that have begun.
  /// @param cells  [subdomain.length()] those of the neighbours are overwritten
  /// @param nodes  [nodes] likewise
  void finish(std::span<float> cells, std::span<float> nodes);

  /// Waits for numbers of the neighbours' nodes.
  /// @param values  [nodes x width] those of the neighbours are overwritten
  void exchange_nodes(std::span<float> values, std::size_t width) const;

 private:
  struct Neighbour {
    int rank;
    CellBox own_cells, ghost_cells;             ///< on both sides of the face
    std::vector<Index> own_nodes, ghost_nodes;  ///< in these cells, in the order of the cells
    std::vector<float> sent, received;          ///< messages: cells, then nodes
  };
  void send();
  void add_places(const CellBox& cells, const std::vector<Index>& nodes, std::vector<Index>& places) const;

  /// Calls visit(number of the first cell, length) for the rows of a box.
  template <class Visit>
  void for_each_row(const CellBox& box, const Visit& visit) const {
    for (int z = box.from[2]; z < box.to[2]; ++z) {
      for (int y = box.from[1]; y < box.to[1]; ++y) {
        visit(subdomain_.number({box.from[0], y, z}), box.width(0));
      }
    }
  }

  Subdomain subdomain_;
  MPI_Comm communicator_ = MPI_COMM_NULL;  // its own, so that no other message is taken for one of a face
  std::vector<Neighbour> neighbours_;
  std::vector<MPI_Request> requests_;
};

}  // namespace idiophone::waves

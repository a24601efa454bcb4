#pragma once
// Which cells of a contact's two partners may overlap, in three lists, each a part of the one before: candidates until
// the next update of the broad phase, close pairs while the partners move only a little, and the pairs whose boxes
// overlap now. They only save time: no pair that is left out overlaps.

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cell_neighbours.hpp"
#include "overlap.hpp"
#include "side.hpp"

namespace idiophone::contact {

class NearPairs {
 public:
  /// Numbers of two cells; of a cell and a part of the shape, if that is the second partner.
  using Pair = std::pair<Index, Index>;

  /// @param first   must outlive this object
  /// @param second  likewise; the same side: a body in contact with itself; null: the partner is a shape
  /// @param shape   null if the partner is a body
  NearPairs(const Side& first, const Side* second, const RigidShape* shape);

  /// Chooses the pairs that may overlap from now on: those whose boxes are within `margin` (m) of each other. Of a body
  /// with itself, each pair once, and none of neighbours.
  /// @param first, second  cells whose positions are known, ascending; parts of the shape, if that is the partner
  void choose_candidates(const std::vector<Index>& first, const std::vector<Index>& second, double margin);

  /// The cells of these pairs, ascending; parts of the shape, if that is the second partner.
  [[nodiscard]] const std::vector<Index>& cells(std::size_t partner) const { return cells_.at(partner); }

  /// Whether there is any such pair.
  [[nodiscard]] bool any_candidates() const { return !candidates_.empty(); }

  /// Finds the pairs whose boxes overlap where the sides are now, but for some of which the cells do not.
  void find();

  /// These pairs, ascending.
  [[nodiscard]] std::span<const Pair> found() const { return found_; }

  /// Forgets the pairs whose boxes overlap.
  void clear() { found_.clear(); }

  /// Forgets all pairs.
  void clear_all();

 private:
  [[nodiscard]] Box box(std::size_t partner, Index cell) const;
  void find_boxes();
  void find_corners();
  [[nodiscard]] int longest_axis() const;
  /// Of a body with itself, each pair is met once.
  [[nodiscard]] bool is_met_first(Index first, Index second) const { return !neighbours_ || first < second; }
  void keep_cells_of_candidates();
  [[nodiscard]] double way_since_chosen() const;
  void choose_close_pairs();
  [[nodiscard]] bool are_apart(const Cell& first, Index second) const;

  const Side* first_;
  const Side* second_;
  const RigidShape* shape_;
  double reach_;                                 ///< of close pairs, m
  std::optional<CellNeighbours> neighbours_;     ///< of a body in contact with itself
  std::array<std::vector<Index>, 2> cells_;      ///< of candidates, ascending
  std::array<std::vector<Box>, 2> boxes_;        ///< of these cells, now
  std::array<std::vector<Vector3>, 2> corners_;  ///< [4 x cells] of these cells, now; none of a shape
  /// The same when the close pairs were chosen; none: not yet.
  std::array<std::vector<Vector3>, 2> chosen_;
  std::vector<Pair> candidates_;  ///< places in `cells_`, ascending
  std::vector<Pair> close_;       ///< those that were within reach of each other
  std::vector<Pair> found_;       ///< those whose boxes overlap, as numbers of cells
};

}  // namespace idiophone::contact

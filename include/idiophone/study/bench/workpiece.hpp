#pragma once
// A body that is cut, and the modes that are tuned.

#include <string>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/removal.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/study/bench/cuttable_mesh.hpp"

namespace idiophone::bench {

/// The body of a deck on one mesh, whose nodes move with the cuts. On this rank alone.
class Workpiece {
 public:
  /// A body with some cuts.
  struct Solved {
    mesh::Mesh mesh;
    std::vector<eigenmodes::Mode> modes;  ///< ascending, with shapes of all nodes; some more than those that are tuned
    std::vector<std::size_t> tuned;       ///< [partials] places in `modes`
  };

  /// @param solids   of one body
  /// @param side     as read_side() reads it
  /// @param numbers  of the modes of the uncut body to tune, from 1 on
  /// @throws what read_side(), mesh::read_mesh(), motion::attach() and eigenmodes::find_modes() throw
  Workpiece(const scene::Solids& solids, const std::string& side, const std::vector<int>& numbers,
            eigenmodes::MassMatrix mass);

  [[nodiscard]] const Side& side() const { return side_; }

  /// Tuned modes are recognised by their shapes (Allemang and Brown 1982).
  /// @throws OutsideOfModel where one is lost, and what CuttableMesh::with() and eigenmodes::find_modes() throw
  [[nodiscard]] Solved with(const std::vector<Cut>& cuts) const;

  /// Of the tuned modes.
  /// @throws what eigenmodes::removal_slopes() throws
  [[nodiscard]] eigenmodes::RemovalSlopes removal_of(const Solved& body) const;

  /// The body with earlier cuts, to which others are added. It refers to this workpiece.
  /// @param here  the body with the earlier cuts
  [[nodiscard]] CutModel model(const std::vector<Cut>& earlier, const Solved& here) const;

 private:
  Workpiece(const scene::Solids& solids, mesh::Mesh mesh, const std::string& side, const std::vector<int>& numbers,
            eigenmodes::MassMatrix mass);

  [[nodiscard]] Solved solve(mesh::Mesh mesh) const;

  const scene::Solids& solids_;
  Side side_;
  CuttableMesh mesh_;
  motion::Attachments attachments_;
  eigenmodes::Options options_;
  Solved uncut_;
};

}  // namespace idiophone::bench

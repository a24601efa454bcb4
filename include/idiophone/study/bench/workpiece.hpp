#pragma once
// A body that is cut, and the modes that are tuned.

#include <optional>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/removal.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/study/bench/cut_side.hpp"
#include "idiophone/study/bench/cuttable_mesh.hpp"
#include "idiophone/study/fitting/material_slopes.hpp"

namespace idiophone::bench {

/// The body of a deck on one mesh, whose nodes move with the cuts. On this rank alone.
class Workpiece {
 public:
  /// A body with some cuts.
  struct Solved {
    mesh::Mesh mesh;
    std::vector<eigenmodes::Mode> modes;  ///< ascending, with shapes of all nodes; some more than those that are tuned
    std::vector<std::optional<std::size_t>> places;  ///< [modes of the uncut body] in `modes`; none of a mode that is
                                                     ///< not recognised any more
    std::vector<std::size_t> tuned;                  ///< [partials] places in `modes`
  };

  /// What removed material does to the tuned modes.
  struct Slopes {
    eigenmodes::RemovalSlopes removal;
    Strips strips;
  };

  /// @param solids   of one body
  /// @param mesh     of the body
  /// @param numbers  of the modes of the uncut body to tune, from 1 on
  /// @throws what CuttableMesh(), motion::attach() and eigenmodes::find_modes() throw
  Workpiece(const scene::Solids& solids, mesh::Mesh mesh, const Side& side, const std::vector<int>& numbers,
            eigenmodes::MassMatrix mass);
  Workpiece(const Workpiece&) = delete;
  Workpiece& operator=(const Workpiece&) = delete;

  [[nodiscard]] const Side& side() const { return side_; }
  [[nodiscard]] double thinnest() const { return mesh_.thinnest(); }  ///< m, between the side and what is behind it
  [[nodiscard]] const Solved& uncut() const { return uncut_; }        ///< of the deck's material
  [[nodiscard]] const scene::Material& material() const;              ///< of the body, or of its first region

  /// All bodies that are solved from now on have this material instead.
  void take(const scene::Material& material);

  /// Modes are recognised by their shapes (Allemang and Brown 1982).
  /// @throws OutsideOfModel where a tuned one is lost, and what CuttableMesh::with() and eigenmodes::find_modes() throw
  [[nodiscard]] Solved with(const std::vector<Cut>& cuts) const;

  /// @param places  of the modes that count
  /// @throws what eigenmodes::removal_slopes() and strips_of() throw
  [[nodiscard]] Slopes slopes_of(const Solved& body, const std::vector<std::size_t>& places) const;

  /// What the constants of the material do to all modes of a body.
  [[nodiscard]] fitting::MaterialSlopes material_slopes_of(const Solved& body) const;

  /// The body with earlier cuts, to which others are added. It refers to this workpiece and to all arguments.
  /// @param here    the body with the earlier cuts
  /// @param strips  slopes of the tuned modes of that body
  [[nodiscard]] CutModel model(const std::vector<Cut>& earlier, const Solved& here, const Strips& strips) const;

 private:
  [[nodiscard]] mesh::Part part_of(const mesh::Mesh& mesh) const;
  [[nodiscard]] Solved solve(mesh::Mesh mesh) const;

  std::vector<scene::Material> materials_;
  scene::Solids solids_;
  Side side_;
  CuttableMesh mesh_;
  motion::Attachments attachments_;
  eigenmodes::Options options_;
  bool is_of_deck_ = true;  ///< its material
  Solved uncut_;
};

}  // namespace idiophone::bench

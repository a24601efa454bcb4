#pragma once
// Drawings of a body with its cuts, for a mill (docs/use/bench.md, DXF).

#include <array>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/study/bench/cut_model.hpp"
#include "idiophone/study/bench/cut_side.hpp"

namespace idiophone::bench {

/// A closed line in side view: places along the body, and along the axis that the side faces, m.
using Profile2 = std::vector<std::array<double, 2>>;

/// The silhouette of a body with some cuts, seen across its side. Between the sections of its mesh it is straight. Cuts
/// have the profiles of their tools: sharp edges of grooves, and hollows by 32 straight pieces.
/// @param mesh  of the body without these cuts
/// @throws std::runtime_error where a cut goes through the body, or the body has a gap along the side
[[nodiscard]] Profile2 profile_of(const mesh::Mesh& mesh, const Side& side, const std::vector<Cut>& cuts);

/// A closed line on a layer of a drawing.
struct Layer {
  std::string name;
  Profile2 profile;
};

/// The text of a drawing in DXF, release 12, in mm.
[[nodiscard]] std::string dxf_of(const std::vector<Layer>& layers);

}  // namespace idiophone::bench

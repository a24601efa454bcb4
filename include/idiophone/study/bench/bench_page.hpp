#pragma once
// The tuning bench as a web page with everything in it.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "idiophone/solids/eigenmodes/removal.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::bench {

/// @param facts    what the command answers to scripts (docs/use/bench.md), and the name of the body as "body"
/// @param removal  slopes of the partials, in the order of the facts
[[nodiscard]] std::string page(const nlohmann::json& facts, const mesh::Mesh& mesh,
                               const eigenmodes::RemovalSlopes& removal);

}  // namespace idiophone::bench

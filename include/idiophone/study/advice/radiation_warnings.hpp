#pragma once
// Whether a radiation model can be trusted for a body.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::advice {

/// Says why the level of a body's sound can be wrong by more than about 2 dB with this model, and where; nothing if it
/// can be trusted. The model huygens has no level.
/// - kirchhoff: the body is thin, open or slender: twice its volume over its surface area is below 0.3 times the radius
/// a
///   of the sphere with its surface area (sphere: 0.67, cube: 0.48, plate of 300 x 300 x 6 mm: 0.05); ka 0.3 to 10
/// - rayleigh: the body is not flat: its thickness is above a tenth of its width
[[nodiscard]] std::optional<std::string> radiation_warning(const std::string& body, const mesh::Statistics& mesh,
                                                           const scene::Radiation& radiation);

/// Those of all computed bodies of a run, on rank 0.
[[nodiscard]] std::vector<std::string> radiation_warnings(const bodies::Preparation& ready);

}  // namespace idiophone::advice

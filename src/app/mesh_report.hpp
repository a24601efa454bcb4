#pragma once
// What `idiophone check` says of the bodies' meshes: their sizes, the pitch, and the cells of waves across thin parts.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/study/advice/pitch_estimate.hpp"
#include "idiophone/study/advice/thickness.hpp"

namespace idiophone::app {

/// Prints edges, volume and the worst element of each mesh.
void report_mesh(const bodies::Preparation& ready);

/// What the mesh does to the pitch of body `b`, where that is heard.
[[nodiscard]] std::optional<std::string> pitch_warning(const bodies::Preparation& ready, std::size_t b);

/// The lowest modes of each body that has a pitch, where that is quick.
/// @param meshes  of the bodies; there is no estimate of those without elements
[[nodiscard]] std::vector<std::optional<advice::PitchEstimate>> pitch_estimates(const bodies::Preparation& ready,
                                                                                const std::vector<mesh::Mesh>& meshes);

/// Prints how exact the pitch of each body is, and warns where it is not.
void report_pitch(const bodies::Preparation& ready, const std::vector<std::optional<advice::PitchEstimate>>& estimates);

/// The smallest cross-section of each body, which waves see; none with other radiation models.
/// @param meshes  of the bodies
[[nodiscard]] std::vector<advice::CrossSection> sections_of(const scene::Scene& scene,
                                                            const std::vector<mesh::Mesh>& meshes);

/// Prints the cells across the thinnest part of each body, and the error of its level.
void report_sections(const std::vector<advice::CrossSection>& sections, const scene::Scene& scene);

}  // namespace idiophone::app

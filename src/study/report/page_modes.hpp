#pragma once
// The modes of the bodies of a run, from files of `idiophone modes` beside it, for the page.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace idiophone::report {

/// Modes of NAME_modes.h5 and NAME_BODY_modes.h5 beside NAME.h5. Only those of the run's own bodies: the same mesh, and
/// the same sections of the deck.
/// @param run  the facts /run of the result
/// @return "bodies": a list of {"body", "left_out": how many have no picture, "modes": a list of {"frequency" (Hz),
///         "decay_time" (s, or null), "mesh_error" (cents, or null), "kind" (can be empty), "picture" (SVG, can be
///         empty)}};
///         "notes": a sentence for each file that is left out
/// @throws std::runtime_error if a file can't be read
[[nodiscard]] nlohmann::json modes_beside(const std::filesystem::path& result, const nlohmann::json& run);

}  // namespace idiophone::report

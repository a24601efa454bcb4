#pragma once
// What moved in a run, for the page: channels over time, and the bodies' surfaces frame by frame.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace idiophone::report {

/// Energies and contact forces of a result, thinned out: in each interval of time, the row with the largest value.
[[nodiscard]] nlohmann::json channels_over_time(const std::filesystem::path& result);

/// Surfaces and their displacements as whole numbers of 16 bits. Long series of frames are thinned out.
[[nodiscard]] nlohmann::json frames(const std::filesystem::path& result);

}  // namespace idiophone::report

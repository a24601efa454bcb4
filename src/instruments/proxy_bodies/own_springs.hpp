#pragma once
// Values of single springs from a CSV file.

#include <filesystem>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxy_bodies {

/// Each row names a spring by the two points that it joins (m), and has its factors of stiffness, damping and natural
/// length. It is the spring whose ends are nearest to the points.
/// @throws deck::DeckError for rows that are wrong, are far from any spring, or name a spring again
[[nodiscard]] std::vector<proxies::OwnSpring> own_springs(const std::filesystem::path& file,
                                                          const proxies::TetrahedralMesh& mesh);

}  // namespace idiophone::proxy_bodies

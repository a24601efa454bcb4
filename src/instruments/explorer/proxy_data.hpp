#pragma once
// What the page needs of a proxy.

#include <nlohmann/json_fwd.hpp>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::explorer {

/// Masses, springs and surface of one level of detail (page/bodies.js, readLevel).
[[nodiscard]] nlohmann::json proxy_data(const proxies::Lattice& lattice);

}  // namespace idiophone::explorer

#pragma once
// From the bodies of a deck to lattices of masses and springs.

#include <memory>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::proxy_bodies {

/// The levels of detail of a body, the finest first: meshes of tetrahedra from its geometry, each with elements twice
/// as large as the one before. Masses of fixed groups are pinned.
/// @throws deck::DeckError for a body that proxies can't be made of
[[nodiscard]] std::vector<std::shared_ptr<const proxies::Lattice>> proxy_levels(const scene::Solids& solids,
                                                                                std::size_t body, int levels);

/// Logs what of the deck the proxies leave out.
void warn_of_what_proxies_lack(const scene::Scene& scene);

}  // namespace idiophone::proxy_bodies

#pragma once
// From the bodies of a deck to lattices of masses and springs.

#include <memory>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::proxy_bodies {

/// How stiff the springs of proxies are.
enum class Springs {
  van_gelder,  ///< by the material and the volume around them, as proxies::Lattice has them
  fitted       ///< so that the proxy has the lowest modes of the body, as proxies::fit_springs() finds them
};

/// The levels of detail of a body, the finest first: meshes of tetrahedra from its geometry, each with elements twice
/// as large as the one before. Masses of fixed groups are pinned. Fitted springs are those of a body of one material;
/// its own values multiply them, as they multiply others. The log has what the fit leaves.
/// @throws deck::DeckError for a body that proxies can't be made of, or whose springs can't be fitted
[[nodiscard]] std::vector<std::shared_ptr<const proxies::Lattice>> proxy_levels(const scene::Solids& solids,
                                                                                std::size_t body, int levels,
                                                                                Springs springs);

/// Logs what of the deck the proxies leave out.
void warn_of_what_proxies_lack(const scene::Scene& scene);

}  // namespace idiophone::proxy_bodies

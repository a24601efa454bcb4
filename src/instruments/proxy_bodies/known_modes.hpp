#pragma once
// The modes of a body, to which the springs of its proxy are fitted.

#include <vector>

#include "idiophone/instruments/proxies/spring_fit.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::proxy_bodies {

/// The lowest modes, by quadratic elements with straight edges and the consistent mass on the tetrahedra of the proxy,
/// or on halved ones where these are few. Fixed groups are held; nothing else acts on the body.
/// @param body   of the solids
/// @param mesh   of the body, tet4, whose nodes are the masses of the proxy
/// @throws std::runtime_error as eigenmodes::find_modes(), or if the body can still move rigidly in some ways only
[[nodiscard]] std::vector<proxies::KnownMode> known_modes(const scene::Solids& solids, std::size_t body,
                                                          const mesh::Mesh& mesh, std::size_t count);

}  // namespace idiophone::proxy_bodies

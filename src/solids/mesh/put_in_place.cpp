#include "put_in_place.hpp"

#include <fmt/format.h>

#include "checks.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/scene/limits.hpp"

namespace idiophone::mesh {

bool is_moved(const scene::Body& body) {
  return !(body.rotation.isZero(0.0) && body.position.isZero(0.0));
}

void put_in_place(const scene::Body& body, std::vector<Vector3>& nodes) {
  if (!is_moved(body)) {
    return;
  }
  const Eigen::Matrix3d turn = body.turn();
  for (Vector3& node : nodes) {
    node = turn * node + body.position;
    if (node.lpNorm<Eigen::Infinity>() > scene::farthest_coordinate) {
      throw deck::DeckError(
          body.mesh_where,
          text_of_problem(body, fmt::format("comes to lie too far away: the deck moves a node to {} m; coordinates "
                                            "must be at least -{} and at most {} m",
                                            to_text(node), scene::farthest_coordinate, scene::farthest_coordinate)));
    }
  }
}

}  // namespace idiophone::mesh

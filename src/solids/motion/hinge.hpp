#pragma once
// A hinge is a line: a body that is held at nodes beside one could not turn.

#include <span>
#include <vector>

#include "idiophone/scene/body.hpp"

namespace idiophone::motion {

/// Requires a hinge's nodes to lie on one straight line, to 1e-6 of the distance between the outermost two.
/// @param nodes      node numbers of its group
/// @param positions  [nodes of the mesh], m
/// @throws deck::DeckError, pointing at the hinge, if there are fewer than two; otherwise it names the node farthest
/// from the line
void require_straight(const scene::FixedGroup& hinge, std::span<const Index> nodes,
                      const std::vector<Vector3>& positions);

}  // namespace idiophone::motion

#pragma once
// Where a body is tapped.

#include <cstddef>
#include <optional>

#include "idiophone/foundation/types.hpp"
#include "idiophone/study/bench/workpiece.hpp"

namespace idiophone::bench {

/// How much a mode moves where it is tapped at right angles to the side that is cut, over its greatest motion: 0 to 1.
/// @param node  of the mesh
[[nodiscard]] double tapped_share(const Workpiece::Solved& body, const Side& side, std::size_t mode, Index node);

/// The node nearest to a place (m).
/// @throws std::runtime_error for a place away from the body
[[nodiscard]] Index tapped_node(const mesh::Mesh& mesh, const Vector3& place);

/// Where a tap excites a mode, and hardly another one.
/// @param mode   place in `body.modes`, as `other`
/// @param other  none: where the mode moves most
/// @return m; none where no such place is
[[nodiscard]] std::optional<Vector3> deciding_place(const Workpiece::Solved& body, const Side& side, std::size_t mode,
                                                    std::optional<std::size_t> other);

inline constexpr double silent_share = 0.05;  ///< of its greatest motion, below which a tap does not excite a mode

}  // namespace idiophone::bench

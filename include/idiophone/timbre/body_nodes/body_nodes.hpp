#pragma once
// The nodes `map` and `proxy`: bodies that a force drives, by a sound map or by a mass-spring proxy.

namespace idiophone::timbre {

/// Makes both nodes known to all trees (add_node_types()). Further calls change nothing.
void add_body_nodes();

}  // namespace idiophone::timbre

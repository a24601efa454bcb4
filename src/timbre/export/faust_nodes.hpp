#pragma once
// The nodes of timbre trees in Faust.

#include <map>
#include <string>
#include <vector>

namespace idiophone::timbre {

/// Definitions that the nodes below use; the beginning of a program.
[[nodiscard]] const char* faust_definitions();

/// An expression for each node with fixed arguments. $0, $1, ... are its arguments, and $n is a noise of its own.
[[nodiscard]] const std::map<std::string, std::string>& faust_nodes();

/// A node of any number of arguments, joined from the left to the right.
/// @return empty if the node is not of this kind
[[nodiscard]] std::string faust_join(const std::string& node, const std::vector<std::string>& arguments);

}  // namespace idiophone::timbre

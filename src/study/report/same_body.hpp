#pragma once
// Whether two results are about the same body.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace idiophone::report {

/// Why the modes of a body in one result say nothing about the body of that name in another one: another mesh, another
/// value in the deck's section of the body or of its material. Empty if they are of the same body.
/// @param run    the facts /run of a run (docs/use/result_file.md)
/// @param modes  those of the file of its modes
[[nodiscard]] std::string difference_of_body(const nlohmann::json& run, const nlohmann::json& modes,
                                             const std::string& body);

}  // namespace idiophone::report

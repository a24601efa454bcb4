#pragma once
// The file of cuts that were made (docs/use/bench.md).

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

/// Reads a YAML file: side: -z, cuts: [{tool: "router:0.003", place: 0.0135, depth: 0.0004}, ...], in m.
/// @param side  that is cut; the file may leave it out, but not name another one
/// @throws deck::DeckError with every mistake; std::runtime_error if the file can't be read
[[nodiscard]] std::vector<Cut> read_cuts(const std::filesystem::path& file, const Side& side);

/// Such a file.
[[nodiscard]] std::string text_of(const std::vector<Cut>& cuts, const Side& side);

}  // namespace idiophone::bench

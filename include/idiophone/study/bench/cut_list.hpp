#pragma once
// The file of cuts that were made, and of taps (docs/use/bench.md).

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/study/bench/cut_model.hpp"
#include "idiophone/study/bench/tap.hpp"

namespace idiophone::bench {

/// What was done to a body so far.
struct Past {
  std::vector<Cut> cuts;  ///< in the order of time, as they were asked for
  std::vector<Tap> taps;  ///< in the order of time
};

/// Reads a YAML file: side: -z, cuts: [{tool: "router:0.003", place: 0.0135, depth: 0.0004}, ...], in m, and
/// taps: [{cuts: 0, lines: [233.3, ...], uncertainties: [1, ...], at: [x, y, z]}, ...], in Hz, cents and m.
/// @param side  that is cut; the file may leave it out, but not name another one
/// @param ends  of the body along it, between which the middles of all cuts lie, m
/// @throws deck::DeckError with every mistake; std::runtime_error if the file can't be read
[[nodiscard]] Past read_past(const std::filesystem::path& file, const Side& side, const std::array<double, 2>& ends);

/// Such a file.
[[nodiscard]] std::string text_of(const Past& past, const Side& side);

}  // namespace idiophone::bench

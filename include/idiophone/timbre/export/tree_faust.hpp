#pragma once
// Timbre trees as programs in Faust.

#include <filesystem>
#include <string>

namespace idiophone::timbre {

/// A program in Faust with the sound of a tree as its output. Parameters that may change become sliders, the others
/// have their defaults.
/// @throws deck::DeckError for a wrong tree, and for a node that Faust's libraries do not have, with its place
[[nodiscard]] std::string faust_program(const std::filesystem::path& file);

}  // namespace idiophone::timbre

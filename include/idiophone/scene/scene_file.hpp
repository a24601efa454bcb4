#pragma once
// How every file that describes a scene is read: it has a name, and its listeners are checked when all else is known.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// Reads a file into a scene: notes the file, its text and the overrides, reads the name, then what `read_rest` reads.
/// @return the tree, with what its readers noted
/// @throws deck::DeckError with every mistake; std::runtime_error if the file can't be read
Node read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides, Scene& scene,
                     const std::function<void(Section& section)>& read_rest);

/// A section of named things that must not be empty.
template <class T, class... Rules>
void require_some(Section& section, const std::string& key, std::vector<T>& things, const Rules&... rules) {
  if (section.required(key, things, rules...) && things.empty()) {
    section.mistakes().add(*section.find(key), "is empty; it needs at least one entry");
  }
}

}  // namespace idiophone::scene

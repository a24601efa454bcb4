#pragma once
// Sounds of trees for tests.

#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/language/graph.hpp"

namespace idiophone::timbre {

/// The first samples of a tree.
inline std::vector<double> sound_of(const std::string& text, std::size_t samples, const Bindings& bindings = {},
                                    const SoundStart& sound_start = {}) {
  Graph graph(parse_tree(text, "t.tt"), bindings, sound_start);
  std::vector<double> sound(samples);
  graph.render(sound);
  return sound;
}

/// What is wrong with a tree; empty if nothing is.
inline std::string mistakes_of(const std::string& text, const Bindings& bindings = {}) {
  try {
    static_cast<void>(sound_of(text, 1, bindings));
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "";
}

/// A binding to a number, said in line 1 of a scene.
inline Binding number(double value) {
  return {.value = value, .where = {"s.yaml", 1, 1}};
}

}  // namespace idiophone::timbre

#pragma once
// Which sounds of bred trees can be told apart by ear.

#include <vector>

#include "idiophone/timbre/evolution/evolution.hpp"
#include "idiophone/timbre/language/timbre_tree.hpp"

namespace idiophone::timbre {

/// The sounds of one generation and of its parents.
class KnownSounds {
 public:
  /// @param duration  of a sound on the page, s; its first 2 s are compared
  KnownSounds(double duration, int rate);

  /// Adds the sound of a tree, unless it is silent.
  void add(const Tree& tree);

  /// Adds the sound of a tree if it is at least `audible_distance` from all others. False for a sound that is like
  /// another one, for a tree that is silent above 20 Hz, and for one whose samples are not finite.
  bool add_if_new(const Tree& tree);

 private:
  /// The audible part of the sound, with a loudest sample of 1; empty for a silent one.
  [[nodiscard]] std::vector<double> heard(const Tree& tree) const;

  std::size_t samples_;
  int rate_;
  std::vector<SoundDistance> known_;
};

}  // namespace idiophone::timbre

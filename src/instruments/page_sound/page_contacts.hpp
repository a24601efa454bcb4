#pragma once
// The contacts of bodies that fall on the page. The page calls it by exports.cpp.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/instruments/touching/contact_sounds.hpp"

namespace idiophone::page_sound {

class PageContacts {
 public:
  /// @param surfaces      by which events name them
  /// @param most_strokes  contacts that scrape or roll at once
  /// @param most_impacts  that begin in a step; a contact of two bodies has one
  PageContacts(std::vector<touching::Surface> surfaces, int rate, std::size_t most_strokes, std::size_t most_impacts,
               std::uint64_t seed);

  /// What the contacts of a step do from an audio sample on. If there are too many impacts, those with the smallest
  /// impulses are left out. Strokes keep all their pieces.
  /// @param events    with their masses; those whose mass is not a positive finite number are left out
  /// @param duration  of the step, s
  [[nodiscard]] std::vector<touching::ContactForce> step(std::span<const touching::ContactEvent> events,
                                                         std::int64_t start, double duration);

 private:
  touching::ContactSounds sounds_;
  std::size_t most_impacts_;
};

}  // namespace idiophone::page_sound

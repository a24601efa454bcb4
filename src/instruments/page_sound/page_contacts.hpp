#pragma once
// The contacts of bodies that fall on the page. The page calls it by exports.cpp.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/instruments/touching/contact_sounds.hpp"

namespace idiophone::page_sound {

class PageContacts {
 public:
  /// @param surfaces     by which events name them
  /// @param most_forces  that begin in a step; a contact of two bodies has one
  PageContacts(std::vector<touching::Surface> surfaces, int rate, std::size_t most_strokes, std::size_t most_forces,
               std::uint64_t seed);

  /// What the contacts of a step do from an audio sample on. If there are too many forces, the weakest impacts are left
  /// out: what scrapes or rolls comes first, then the impacts with the largest impulses.
  /// @param events    with their masses
  /// @param duration  of the step, s
  [[nodiscard]] std::vector<touching::ContactForce> step(std::span<const touching::ContactEvent> events,
                                                         std::int64_t start, double duration);

 private:
  touching::ContactSounds sounds_;
  std::size_t most_forces_;
};

}  // namespace idiophone::page_sound

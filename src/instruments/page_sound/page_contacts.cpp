#include "page_contacts.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace idiophone::page_sound {

PageContacts::PageContacts(std::vector<touching::Surface> surfaces, int rate, std::size_t most_strokes,
                           std::size_t most_forces, std::uint64_t seed)
    : sounds_(std::move(surfaces), {}, rate, most_strokes, seed), most_forces_(most_forces) {}

std::vector<touching::ContactForce> PageContacts::step(std::span<const touching::ContactEvent> events,
                                                       std::int64_t start, double duration) {
  std::vector<touching::ContactForce> forces = sounds_.step(events, start, duration);
  if (forces.size() > most_forces_) {
    std::ranges::stable_sort(forces, std::ranges::greater(), &touching::ContactForce::impulse);
    forces.resize(most_forces_);
  }
  return forces;
}

}  // namespace idiophone::page_sound

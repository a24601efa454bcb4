#include "page_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace idiophone::page_sound {

namespace {

bool has_mass(const touching::ContactEvent& event) {
  return event.mass > 0.0 && std::isfinite(event.mass);
}

bool is_piece_of_stroke(const touching::ContactForce& force) {
  return std::isinf(force.impulse);
}

}  // namespace

PageContacts::PageContacts(std::vector<touching::Surface> surfaces, int rate, std::size_t most_strokes,
                           std::size_t most_impacts, std::uint64_t seed)
    : sounds_(std::move(surfaces), {}, rate, most_strokes, seed), most_impacts_(most_impacts) {}

std::vector<touching::ContactForce> PageContacts::step(std::span<const touching::ContactEvent> events,
                                                       std::int64_t start, double duration) {
  std::vector<touching::ContactEvent> right;
  std::ranges::copy_if(events, std::back_inserter(right), has_mass);
  std::vector<touching::ContactForce> forces = sounds_.step(right, start, duration);
  const auto impacts = std::ranges::stable_partition(forces, is_piece_of_stroke);
  if (impacts.size() > most_impacts_) {
    std::ranges::stable_sort(impacts, std::ranges::greater(), &touching::ContactForce::impulse);
    forces.erase(impacts.begin() + static_cast<std::ptrdiff_t>(most_impacts_), forces.end());
  }
  return forces;
}

}  // namespace idiophone::page_sound

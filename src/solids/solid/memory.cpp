#include "idiophone/solids/solid/memory.hpp"

#include <cmath>

namespace idiophone::solid {

Memory::Memory(const Relaxation& relaxation, double beta, double step, std::size_t packs, std::size_t points)
    : step_(step),
      long_term_(relaxation.long_term),
      damping_(beta / step),
      points_(points),
      overstrain_(relaxation.mechanisms.size() * points * packs) {
  for (const auto& [strength, rate] : relaxation.mechanisms) {
    mechanisms_.push_back({std::exp(-rate * step), strength * -std::expm1(-rate * step) / (rate * step), strength});
  }
}

void Memory::archive(std::size_t element, parallel::ArchiveRow& row) {
  const std::size_t count = points_ * mechanisms_.size();
  for (PackSymmetric& overstrain : std::span(overstrain_).subspan(element / lanes * count, count)) {
    for (Pack& component : overstrain.at) {
      double number = component[element % lanes];
      row.value(number);
      component[element % lanes] = number;
    }
  }
}

}  // namespace idiophone::solid

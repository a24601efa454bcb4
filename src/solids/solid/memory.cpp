#include "idiophone/solids/solid/memory.hpp"

#include <cmath>

namespace idiophone::solid {

Memory::Memory(const Relaxation& relaxation, double beta, double step, PackRange packs, std::size_t points)
    : step_(step),
      long_term_(relaxation.long_term),
      damping_(beta / step),
      points_(points),
      first_(packs.begin * points),
      overstrain_(relaxation.mechanisms.size() * points * (packs.end - packs.begin)) {
  for (const auto& [strength, rate] : relaxation.mechanisms) {
    mechanisms_.push_back({std::exp(-rate * step), strength * -std::expm1(-rate * step) / (rate * step), strength});
  }
}

void Memory::archive(std::size_t pack, std::size_t lane, parallel::ArchiveRow& row) {
  for (PackSymmetric& overstrain : std::span(at(pack * points_), points_ * mechanisms_.size())) {
    for (Pack& component : overstrain.at) {
      double number = component[lane];
      row.value(number);
      component[lane] = number;
    }
  }
}

}  // namespace idiophone::solid

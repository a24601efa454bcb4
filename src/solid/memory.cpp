#include "idiophone/solid/memory.hpp"

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

template <class Packs, class Visitor>
void Memory::for_each(Packs& overstrain, std::size_t width, std::size_t elements, Visitor visit) {
  const std::size_t in_pack = width / 6;
  for (std::size_t element = 0; element < elements; ++element) {
    for (std::size_t i = 0; i < width; ++i) {
      auto& pack = overstrain[element / lanes * in_pack + i / 6];
      visit(element * width + i, pack.at[i % 6], element % lanes);
    }
  }
}

std::vector<double> Memory::save(std::size_t elements) const {
  std::vector<double> rows(width() * elements);
  for_each(overstrain_, width(), elements,
           [&](std::size_t place, const Pack& pack, std::size_t lane) { rows[place] = pack[lane]; });
  return rows;
}

void Memory::restore(std::span<const double> rows) {
  for_each(overstrain_, width(), rows.size() / width(),
           [&](std::size_t place, Pack& pack, std::size_t lane) { pack[lane] = rows[place]; });
}

}  // namespace idiophone::solid

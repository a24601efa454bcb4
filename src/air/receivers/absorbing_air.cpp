#include "idiophone/air/receivers/absorbing_air.hpp"

#include <cmath>

#include "zero_phase.hpp"

namespace idiophone::receivers {

std::vector<double> AbsorbingAir::response(std::int64_t number) const {
  return zero_phase_filter(half_width(), rate_, [&](double frequency) {
    return std::exp(-atmosphere_.attenuation(frequency) * static_cast<double>(number));
  });
}

}  // namespace idiophone::receivers

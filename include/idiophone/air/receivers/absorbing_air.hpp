#pragma once
// Atmospheric absorption as filters: one for each metre of distance.

#include <cstdint>
#include <vector>

#include "idiophone/air/radiation/absorption.hpp"

namespace idiophone::receivers {

/// Filter number n has the frequency response of n metres of air. A distance between two whole metres interpolates
/// between two filters, so that the sound changes smoothly with the distance. The loss is then within
/// (alpha metre)^2/8 of the exact one: 0.01 dB if the attenuation is 0.8 dB per metre.
class AbsorbingAir {
 public:
  AbsorbingAir(const radiation::Atmosphere& atmosphere, int rate) : atmosphere_(atmosphere), rate_(rate) {}

  /// Audio samples of a response before and after its middle: 2 ms, longer than the tail of nitrogen's relaxation.
  [[nodiscard]] std::size_t half_width() const { return static_cast<std::size_t>(rate_) / 500; }

  /// The zero-phase filter exp(-alpha(f) n metres): [2 half_width() + 1] taps, symmetric about the middle.
  [[nodiscard]] std::vector<double> response(std::int64_t number) const;

 private:
  radiation::Atmosphere atmosphere_;
  int rate_;
};

}  // namespace idiophone::receivers

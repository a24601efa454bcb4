#pragma once
// Air that absorbs, as filters: one for each metre that sound has come.

#include <cstdint>
#include <vector>

#include "idiophone/radiation/absorption.hpp"

namespace idiophone::listening {

/// Filter number n lets pass what is left after n metres. Sounds from between two whole metres are shared between two
/// filters, so that what is heard changes smoothly with the distance: the loss is then within (alpha metre)^2/8 of the
/// exact one, 0.01 dB where the air takes 0.8 dB a metre.
class AbsorbingAir {
 public:
  AbsorbingAir(const radiation::Atmosphere& atmosphere, int rate) : atmosphere_(atmosphere), rate_(rate) {}

  /// Audio samples that a response reaches to either side: 2 ms, in which the slow tail of nitrogen's relaxation is
  /// over.
  [[nodiscard]] std::size_t half_width() const { return static_cast<std::size_t>(rate_) / 500; }

  /// exp(-alpha(f) n metres), which shifts no phase: [2 half_width() + 1] taps, the same to both sides of the middle.
  [[nodiscard]] std::vector<double> response(std::int64_t number) const;

 private:
  radiation::Atmosphere atmosphere_;
  int rate_;
};

}  // namespace idiophone::listening

#pragma once
// Bodies that are computed sample by sample, because they touch each other or something else.

#include <span>

#include "idiophone/instruments/resonators/point_contacts.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::resonators {

/// A body and what ResonatorBank::advance() would get for it.
struct BodyInContact {
  ResonatorBank* bank = nullptr;
  std::span<const Drive> drives{};
  std::span<const ModeGroup> gains{};  ///< [outputs x groups]
  std::size_t outputs = 1;
  std::span<double> sound{};  ///< [samples x outputs]
};

/// Advances bodies by as many audio samples each, while contacts act, whose forces are found, or stretching couples the
/// modes. In every sample, all bodies move freely, then the contacts find their forces, and then these act on all
/// bodies. No allocation.
/// @param bodies  as the contacts number them
void advance_together(std::span<const BodyInContact> bodies, PointContacts& contacts);

}  // namespace idiophone::resonators

#pragma once
// Numbers of modes in groups, as the processor computes them at once.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/vector_register.hpp"
#include "idiophone/instruments/resonators/damped_oscillator.hpp"

namespace idiophone::resonators {

/// One number for each of as many modes as fit into a register.
using ModePack = double __attribute__((vector_size(register_size)));
inline constexpr std::size_t modes_in_pack = register_size / sizeof(double);

/// Packs that are computed at once, because each operation waits for the one before.
inline constexpr std::size_t packs_in_group = 4;
inline constexpr std::size_t modes_in_group = packs_in_group * modes_in_pack;

/// A complex number for each mode of a group.
struct ModeGroup {
  std::array<ModePack, packs_in_group> real{}, imaginary{};
};

/// One complex number a mode in groups; what is missing in the last group is zero.
[[nodiscard]] std::vector<ModeGroup> in_groups(std::span<const Complex> values);

/// Of a mode of a group. @param mode  its number there, or in all groups
[[nodiscard]] Complex value_of(const ModeGroup& group, std::size_t mode);

}  // namespace idiophone::resonators

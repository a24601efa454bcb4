#pragma once
// What sounds of a map lack where they are those of small vibrations only.

#include <string_view>

namespace idiophone::sound_maps {

/// The end of a warning: "the page has no large amplitudes: ...".
inline constexpr std::string_view without_large_amplitudes =
    "has no large amplitudes: the pitch does not depend on them, as in small vibrations";

}  // namespace idiophone::sound_maps

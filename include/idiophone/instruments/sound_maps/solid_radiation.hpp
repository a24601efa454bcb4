#pragma once
// The choice of a model for the air at the surface of a solid.

#include <optional>
#include <string>

#include "idiophone/instruments/sound_maps/modal_radiation.hpp"

namespace idiophone::sound_maps {

/// Who computes the air at the surface.
enum class SurfaceModel { boundary_elements, kirchhoff };

struct SolidRadiation {
  ModalRadiation radiation;
  std::string name;   ///< SoundMap::radiation
  std::string doubt;  ///< why it is not boundary elements alone though nobody asked for that, and what helps; or empty
};

/// @param map     of a solid, with its modes and its surface
/// @param wanted  none: boundary elements if the surface is closed and they take less than two minutes on one core
/// @throws std::invalid_argument as boundary_elements(), and where they are wanted for a surface that is open at the
///         borders of joints
[[nodiscard]] SolidRadiation solid_radiation(const SoundMap& map, const scene::Radiation& radiation,
                                             std::optional<SurfaceModel> wanted);

}  // namespace idiophone::sound_maps

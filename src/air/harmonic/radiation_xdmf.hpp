#pragma once
// NAME_radiation.xdmf, which shows the pressure at the surface in ParaView.

#include <string>

#include "idiophone/air/harmonic/body_radiation.hpp"

namespace idiophone::harmonic {

/// The sounds take the place of time by their numbers, from 1 on.
/// @param file  name of the HDF5 file beside it
[[nodiscard]] std::string xdmf_text(const std::string& file, const Radiation& radiation);

}  // namespace idiophone::harmonic

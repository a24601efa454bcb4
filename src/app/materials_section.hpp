#pragma once
// A material as text.

#include <string>

#include "idiophone/scene/material.hpp"

namespace idiophone::app {

/// The section `materials` of a deck with this material. Numbers have six digits.
[[nodiscard]] std::string materials_section(const scene::Material& material);

}  // namespace idiophone::app

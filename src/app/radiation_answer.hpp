#pragma once
// What `idiophone radiate` answers and writes.

#include <cstddef>
#include <filesystem>
#include <string>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/foundation/origin.hpp"
#include "idiophone/scene/scene.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

/// The name of a result, without .h5.
/// @param name    of the deck
/// @param bodies  of the deck
/// @param body    that moves
[[nodiscard]] std::string radiation_name(const std::string& name, std::size_t bodies, const std::string& body);

/// What of the listeners and of the air does not reach the result.
void warn_of_unheard(const scene::Scene& scene);

/// Writes a result and prints its table, or the same for scripts with the pressures at the listeners. On rank 0.
void write_and_print(const std::filesystem::path& path, const Origin& origin, const harmonic::Radiation& result,
                     Style style);

}  // namespace idiophone::app

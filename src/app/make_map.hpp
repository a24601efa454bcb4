#pragma once
// The steps that `idiophone map` takes for each body.

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <string>

#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/scene/scene.hpp"
#include "map_options.hpp"
#include "map_outcome.hpp"

namespace idiophone::app {

/// The name of a body's map, without .h5.
[[nodiscard]] std::string map_name(const scene::Scene& scene, const std::string& body);

[[nodiscard]] std::filesystem::path path_of_map(const MapOptions& options, const std::string& name);

/// Makes a map, with or without its radiation. Called on rank 0.
using FindModes = std::function<sound_maps::SoundMap()>;

/// Makes the air at the surface of a map, and names its model in the map. Called on all ranks.
using FindRadiation = std::function<sound_maps::ModalRadiation(sound_maps::SoundMap& map)>;

/// Writes the map of one body. After a signal, it leaves it out. A body without modes is reported, and no reason to
/// stop. Collective.
void make_map(const MapOptions& options, const scene::Scene& scene, const std::string& body, const FindModes& modes,
              const FindRadiation& radiation, MapOutcome& outcome, MPI_Comm communicator);

}  // namespace idiophone::app

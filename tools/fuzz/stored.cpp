#include <mpi.h>

#include <fstream>

#include "hdf5_mutations.hpp"
#include "idiophone/air/harmonic/radiation_file.hpp"
#include "idiophone/files/reading_limit.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/checkpoint.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "readers.hpp"
#include "stored_readers.hpp"
#include "velocity_file.hpp"

namespace idiophone::fuzz {

namespace {

using File = std::filesystem::path;

/// What `idiophone info` and `idiophone info --verify` read.
void read_contents(const File& file) {
  mutants::describe(file);
  mutants::verify(file);
}

void read_checkpoint(const File& file) {
  const results::CheckpointReader reader(file, MPI_COMM_WORLD);
  static_cast<void>(reader.read_integer_root("run/advanced"));
}

void read_sound_map(const File& file) {
  static_cast<void>(sound_maps::read_sound_map(file));
}

void read_radiation(const File& file) {
  static_cast<void>(harmonic::read_radiation(file));
}

void read_stored_mesh(const File& file) {
  static_cast<void>(mesh::read_mesh_file(file));
}

void read_mesh_in_parts(const File& file) {
  mutants::read_mesh_in_parts(file, {"body"});  // of all shipped geometries
}

void read_given_motion(const File& file) {
  deck::Mistakes mistakes;
  static_cast<void>(harmonic::hdf5_velocities(file, mistakes));
  mistakes.raise();
}

/// Half of the mutants have a right structure and wrong contents.
std::string mutated_file(std::string bytes, mutants::Random& random) {
  if (mutants::below(2, random) == 0) {
    return mutants::mutated_bytes(std::move(bytes), random);
  }
  const File file = "mutant.h5";
  std::ofstream(file, std::ios::binary) << bytes;
  const files::ReadingLimit limit(file);
  mutants::mutate_hdf5(file, random);
  return deck::read_text(file);
}

}  // namespace

std::vector<Reader> stored_readers() {
  return {{"contents", ".h5", read_contents, mutated_file},
          {"series", ".h5", mutants::read_series, mutated_file},
          {"sounds", ".h5", mutants::read_sounds, mutated_file},
          {"frames", ".h5", mutants::read_frames, mutated_file},
          {"recording", ".h5", mutants::read_recording, mutated_file},
          {"sound_map", ".h5", read_sound_map, mutated_file},
          {"radiation", ".h5", read_radiation, mutated_file},
          {"stored_mesh", ".h5", read_stored_mesh, mutated_file},
          {"mesh_in_parts", ".h5", read_mesh_in_parts, mutated_file},
          {"given_motion", ".h5", read_given_motion, mutated_file},
          {"checkpoint", ".h5", read_checkpoint, mutated_file, false}};
}

}  // namespace idiophone::fuzz

#include <mpi.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hdf5_mutations.hpp"
#include "idiophone/files/reading_limit.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/checkpoint.hpp"
#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/mode_reader.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "readers.hpp"

namespace idiophone::fuzz {

namespace {

using File = std::filesystem::path;

/// What `idiophone info` reads of every file.
void read_contents(const File& file) {
  static_cast<void>(contents::describe(file));
  static_cast<void>(contents::describe_as_json(file));
  static_cast<void>(results::verify(file));
}

void read_series(const File& file) {
  const results::SeriesReader reader(file);
  for (const auto& series : reader.all()) {
    static_cast<void>(reader.read(series));
  }
}

void read_sounds(const File& file) {
  static_cast<void>(results::read_sounds(file));
  static_cast<void>(results::read_references(file));
  static_cast<void>(results::read_modes(file));
}

void read_frames(const File& file) {
  const results::FrameReader reader(file);
  for (std::size_t body = 0; body < reader.bodies().size(); ++body) {
    for (std::size_t frame = 0; frame < reader.times().size(); ++frame) {
      static_cast<void>(reader.displacement(body, frame));
    }
  }
}

void read_recording(const File& file) {
  const results::SurfaceMotionReader reader(file);
  static_cast<void>(reader.read_triangles(0, reader.triangles()));
  static_cast<void>(reader.read_reference(0, reader.vertices()));
  for (std::int64_t row = 0; row < reader.rows(); ++row) {
    static_cast<void>(reader.read_pressure(row, 1, 0, reader.triangles()));
    static_cast<void>(reader.read_position(row, 1, 0, reader.vertices()));
  }
}

void read_checkpoint(const File& file) {
  const results::CheckpointReader reader(file, MPI_COMM_WORLD);
  static_cast<void>(reader.read_integer_root("run/advanced"));
}

void read_sound_map(const File& file) {
  static_cast<void>(sound_maps::read_sound_map(file));
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
          {"series", ".h5", read_series, mutated_file},
          {"sounds", ".h5", read_sounds, mutated_file},
          {"frames", ".h5", read_frames, mutated_file},
          {"recording", ".h5", read_recording, mutated_file},
          {"sound_map", ".h5", read_sound_map, mutated_file},
          {"checkpoint", ".h5", read_checkpoint, mutated_file, false}};
}

}  // namespace idiophone::fuzz

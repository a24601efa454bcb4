// Results, modes, recordings, checkpoints, sound maps, radiated sounds and meshes.

#include <mpi.h>

#include <nlohmann/json.hpp>

#include "fixture.hpp"
#include "flat_checksum.hpp"
#include "hash.hpp"
#include "hdf5_mutations.hpp"
#include "idiophone/air/harmonic/radiation_file.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/text_file.hpp"
#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "idiophone/run/results/surface_motion_file.hpp"
#include "idiophone/solids/mesh/faces.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "results.hpp"
#include "small_map.hpp"
#include "small_radiation.hpp"
#include "stored_readers.hpp"

namespace idiophone::mutants {

namespace {

using File = std::filesystem::path;

class Stored : public Mutants {
 protected:
  static void SetUpTestSuite() { MPI_Init(nullptr, nullptr); }
  static void TearDownTestSuite() { MPI_Finalize(); }
};

/// Every second mutant has wrong bytes, the others wrong contents.
void mutate(const File& file, Random& random) {
  below(2, random) == 0 ? mutate_bytes(file, random) : mutate_hdf5(file, random);
}

void make_recording(const File& file) {
  const parallel::Rows rows({{0, 1, 2, 3}}, 4, MPI_COMM_WORLD);
  const std::vector<std::int32_t> corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const std::vector<double> reference = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  auto recording = results::SurfaceMotionFile::create(file,
                                                      {.origin = results::origin,
                                                       .rate = 8000,
                                                       .first_sample = -6,
                                                       .samples = 30,
                                                       .air_density = 1.2,
                                                       .air_speed = 340,
                                                       .bodies = {{"plate", 0, 0}, {"hammer", 2, 1}},
                                                       .obstacle_triangles = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                       .half_spaces = {0, 0, -1, 0, 0, 1}},
                                                      {&rows, &rows, corners, reference}, MPI_COMM_WORLD);
  recording.append(40, std::vector<double>(160, 1.5), std::vector<double>(480, 0.25));
  recording.flush();
}

void make_modes(const File& file) {
  auto result = results::ResultFile::create(file, results::origin, MPI_COMM_WORLD);
  result.declare(results::ears);
  result.append(results::ears.path, results::audio(0, 100));
  result.add_reference("thin plate", {161.2, 329.0});
  results::add_mesh(result, results::plate, 0);
  const parallel::Rows nodes(support::dealt(results::plate.nodes(), 0), results::plate.nodes(), MPI_COMM_WORLD);
  const std::vector<double> shape(static_cast<std::size_t>(3 * results::plate.nodes()), 0.5);
  result.add_modes({.body = "plate",
                    .nodes = &nodes,
                    .mass = "lumped",
                    .rigid_motions = 0,
                    .frequencies = {100, 200},
                    .damping_ratios = {0.001, 0.002},
                    .decay_times = {1, 2},
                    .mesh_errors = {3, -4},
                    .kinetic_shares = {1, 1},
                    .kinds = {"(2, 0)", ""},
                    .shapes = {shape, shape}});
  result.flush();
}

void expect_stored(const std::string& type, const File& original, const std::function<void(const File&)>& read) {
  expect_answers({.type = type, .originals = {original}, .mutate = mutate, .read = read});
}

/// With all facts about a run that `idiophone info` prints.
void make_result_with_facts(const File& file) {
  auto result = results::make_result(file, 0);
  const nlohmann::json body = {{"nodes", 70}, {"elements", 7}, {"element", "tet10"}, {"triangles", 28}, {"mass", 0.5}};
  result.note("/run", {{"step", 1e-6}, {"steps_per_sample", 20}, {"steps_per_read", 4}, {"bodies", {{"plate", body}}}});
  result.add_job({{"ranks", 2},
                  {"instruction_set", "x86-64-v3"},
                  {"first_sample", 0},
                  {"last_sample", 100},
                  {"elapsed", 1.5},
                  {"elements_per_second", 1e6},
                  {"stages", {{"motion", 1.0}, {"radiation", 0.5}}}});
  result.flush();
}

TEST_F(Stored, Result) {
  const File result = folder / "plate.h5";
  make_result_with_facts(result);
  expect_stored("result_info", result, describe);
  expect_stored("result_verify", result, verify);
  expect_stored("result_series", result, read_series);
  expect_stored("result_frames", result, read_frames);
}

TEST_F(Stored, Sounds) {
  make_modes(folder / "plate.h5");
  expect_stored("sounds", folder / "plate.h5", read_sounds);
}

TEST_F(Stored, Recording) {
  const File recording = folder / "plate_surface.h5";
  make_recording(recording);
  expect_stored("recording", recording, read_recording);
  expect_stored("recording_info", recording, describe);
  expect_stored("recording_verify", recording, verify);
}

TEST_F(Stored, SoundMap) {
  const File map = folder / "plate.map.h5";
  sound_maps::write_sound_map(map, sound_maps::small_map());
  expect_stored("sound_map", map, [](const File& file) { static_cast<void>(sound_maps::read_sound_map(file)); });
  expect_stored("sound_map_info", map, describe);
}

/// A flat file, also with a right checksum: what the contents say is not believed either.
void expect_flat(const std::string& type, const File& flat, const std::function<void(const File&)>& read) {
  expect_answers({.type = type, .originals = {flat}, .mutate = mutate_bytes, .read = read});
  const auto mutate_contents = [original = deck::read_text(flat)](const File& file, Random& random) {
    mutate_bytes(file, random);
    std::string bytes = deck::read_text(file);
    constexpr std::size_t head = 20;  // the magic and the version
    if (bytes.size() > head) {
      bytes.replace(0, head, original, 0, head);
    }
    write_text(file, with_right_checksum(bytes));
  };
  expect_answers({.type = type + "_contents", .originals = {flat}, .mutate = mutate_contents, .read = read});
}

TEST_F(Stored, Voice) {
  write_text(folder / "plate.voice", sound_maps::voice_file(sound_maps::small_map()));
  expect_flat("voice", folder / "plate.voice",
              [](const File& file) { static_cast<void>(sound_maps::read_voice(file)); });
}

TEST_F(Stored, Proxy) {
  const auto lattice = [](int cells) {
    return std::make_shared<const proxies::Lattice>(
        proxies::grid_mesh({cells, cells, 1}, [](const Vector3& at) { return Vector3(0.1 * at); }),
        proxies::Material{.young = 1e6, .density = 1000.0, .damping = {.mass = 5.0, .stiffness = 1e-5}});
  };
  write_text(folder / "plate.proxy", proxies::proxy_file({.name = "plate", .levels = {lattice(2), lattice(1)}}));
  expect_flat("proxy", folder / "plate.proxy", [](const File& file) { static_cast<void>(proxies::read_proxy(file)); });
}

TEST_F(Stored, Radiation) {
  harmonic::write_radiation(folder / "plate_radiation.h5", results::origin, harmonic::small_radiation());
  expect_stored("radiation", folder / "plate_radiation.h5",
                [](const File& file) { static_cast<void>(harmonic::read_radiation(file)); });
  expect_stored("radiation_info", folder / "plate_radiation.h5", describe);
}

/// A checkpoint, and a result that goes on after it.
File make_stopped_run(const File& result_file) {
  auto result = results::make_result(result_file, 0);
  File checkpoints = result_file.parent_path() / "checkpoints";
  results::save(checkpoints, 7, [&](auto& archive) { result.archive(archive); });
  result.append(results::ears.path, results::audio(100, 9000));
  result.flush();
  return checkpoints;
}

/// Two tetrahedra with groups.
mesh::StoredMesh small_mesh() {
  mesh::StoredMesh stored;
  stored.body = "plate";
  stored.mesh.element = element::tet4;
  stored.mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  stored.mesh.elements = {0, 1, 2, 3, 0, 2, 1, 4};
  stored.mesh.surface = mesh::exterior_triangles(stored.mesh);
  stored.mesh.groups = {{"rim", {0, 1, 2}}, {"tip", {3}}};
  stored.mesh.group_triangles = {{"rim", {{0, 1, 2}}}};
  stored.mesh.hash = mesh::hash_of(stored.mesh);
  stored.element_groups = {{"lower", {1}}, {"upper", {0}}};
  return stored;
}

TEST_F(Stored, Mesh) {
  const File file = folder / "plate.mesh.h5";
  mesh::write_mesh_file(file, small_mesh(), results::origin);
  expect_stored("mesh", file, [](const File& mutant) {
    scene::Body body;
    body.name = "plate";
    body.mesh = mutant;
    body.element = element::tet4;
    static_cast<void>(mesh::read_mesh(body));
  });
  expect_stored("mesh_in_parts", file, [](const File& mutant) { read_mesh_in_parts(mutant, {"lower", "upper"}); });
  expect_stored("mesh_info", file, describe);
}

TEST_F(Stored, Checkpoint) {
  const File checkpoint = make_stopped_run(folder / "plate.h5") / "checkpoint_000000000007.h5";
  const auto read = [](const File& file) {
    const results::CheckpointReader reader(file, MPI_COMM_WORLD);
    for (const auto* name : {"run/lengths/audio/ears", "run/lengths/energy"}) {
      static_cast<void>(reader.read_integer_root(name));
    }
  };
  expect_answers({.type = "checkpoint",
                  .originals = {checkpoint},
                  .mutate = mutate,
                  .read = read,
                  .named = " "});  // find_checkpoint() says the name
  expect_stored("checkpoint_info", checkpoint, describe);
  expect_stored("checkpoint_verify", checkpoint, verify);
}

TEST_F(Stored, ResumedResult) {
  const File checkpoints = make_stopped_run(folder / "plate.h5");
  expect_stored("resumed_result", folder / "plate.h5", [&](const File& file) {
    const auto found = results::find_checkpoint(checkpoints, results::identity,
                                                {{file, results::ResultFile::archive_prefix}}, MPI_COMM_WORLD);
    if (found.checkpoint) {
      results::RestoringArchive archive(*found.checkpoint, MPI_COMM_WORLD);
      results::ResultFile::open(file, MPI_COMM_WORLD).archive(archive);
    }
  });
}

}  // namespace

}  // namespace idiophone::mutants

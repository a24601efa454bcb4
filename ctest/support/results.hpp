#pragma once
// A small result with all that a result can hold: two bodies, frames, audio, energies, a reference.

#include <hdf5.h>
#include <zlib.h>

#include "idiophone/run/results/checkpoint_archive.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "shared_folder.hpp"

namespace idiophone::results {

using namespace support;
using parallel::Rows;

inline const Origin origin{.name = "plate & hammer",
                           .code_version = "0.1.0",
                           .deck_text = "name: plate # gr\xc3\xbc\xc3\x9f\n",
                           .overrides = {"a=1"}};
inline const spectra::Series ears{.path = "/audio/ears",
                                  .unit = "Pa m",
                                  .rate = 44100.0,
                                  .columns = {"ears.left", "ears.right"},
                                  .description = "sound at two receivers",
                                  .positions = {{-0.1, 0.0, 1.0}, {0.1, 0.0, 1.0}}};
inline const spectra::Series energy{.path = "/energy",
                                    .unit = "J",
                                    .rate = 2000.0,
                                    .columns = {"kinetic", "elastic", "gravity"},
                                    .description = "energies of all bodies",
                                    .positions = {}};

/// Audio rows [begin, end), [2 x rows].
inline std::vector<double> audio(std::int32_t begin, std::int32_t end) {
  std::vector<std::int32_t> rows;
  for (auto row = begin; row < end; ++row) {
    rows.push_back(row);
  }
  return values_of(rows, 2);
}

/// Tetrahedra that share no nodes; a node's place is its displacement in frame 1.
struct TestBody {
  std::string name;
  element::Type type;
  std::int32_t elements;
  [[nodiscard]] std::int32_t nodes() const { return elements * element::node_count(type); }
};
inline const TestBody plate{"plate", element::tet10, 7};
inline const TestBody hammer{"hammer", element::tet4, 2};

inline void add_mesh(ResultFile& result, const TestBody& body, int first) {
  const auto nodes = dealt(body.nodes(), first);
  const auto elements = dealt(body.elements, first);
  std::vector<std::int32_t> element_nodes;
  for (const auto element : elements) {
    const int width = element::node_count(body.type);
    for (int node = 0; node < width; ++node) {
      element_nodes.push_back(element * width + node);
    }
  }
  result.add_mesh(body.name, Rows(nodes, body.nodes(), MPI_COMM_WORLD), values_of(nodes, 3),
                  Rows(elements, body.elements, MPI_COMM_WORLD), element_nodes, body.type);
}

/// Frame f displaces node n by f (1, 2, 3)/(3 + n), at f/60 s.
inline void add_frame(ResultFile& result, int frame, int first, const std::vector<TestBody>& bodies = {plate, hammer}) {
  std::vector<Rows> rows;
  std::vector<std::vector<double>> displacements;
  for (const auto& body : bodies) {
    const auto nodes = dealt(body.nodes(), first);
    rows.emplace_back(nodes, body.nodes(), MPI_COMM_WORLD);
    displacements.push_back(values_of(nodes, 3));
    for (auto& value : displacements.back()) {
      value *= frame;
    }
  }
  std::vector<BodyFrame> frames;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    frames.push_back({bodies[i].name, &rows[i], displacements[i]});
  }
  result.add_frame(frame / 60.0, frames);
}

/// Closed by flush, open again for more. `first` changes which rank has which rows.
inline ResultFile make_result(const std::filesystem::path& path, int first) {
  auto result = ResultFile::create(path, origin, MPI_COMM_WORLD);
  result.declare(ears);
  result.declare(energy);
  result.add_reference("thin plate (Leissa) 1/2", {161.2, 329.0});
  add_mesh(result, plate, first);
  add_mesh(result, hammer, first);
  for (int frame = 0; frame < 3; ++frame) {
    add_frame(result, frame, first);
  }
  result.append(ears.path, rank() == 0 ? audio(0, 100) : std::vector<double>());
  result.append(energy.path, std::vector<double>(12, 0.5));
  result.flush();
  return result;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The only place of a number among the bytes of a file. Numbers with short binary fractions are no use here: the bytes
/// of 2.0 also occur in what HDF5 writes about itself.
inline std::size_t place_of(const std::string& bytes, double number) {
  const std::string pattern(reinterpret_cast<const char*>(&number), sizeof number);  // NOLINT(*-reinterpret-cast)
  const auto place = bytes.find(pattern);
  EXPECT_NE(place, std::string::npos) << number << " is not in the file";
  EXPECT_EQ(place, bytes.rfind(pattern)) << number << " is in the file more than once";
  return place;
}

inline const Identity identity{.code_version = "0.1.0",
                               .mesh_hash = "0123456789abcdef",
                               .deck_text = "name: plate\n",
                               .overrides = {"a=1", "b=2"}};

/// Writes a checkpoint of whatever `state` archives.
template <class State>
void save(const std::filesystem::path& directory, std::int64_t step, const State& state) {
  CheckpointWriter writer(directory, identity, {.step = step, .sample = step}, MPI_COMM_WORLD);
  SavingArchive archive(writer, MPI_COMM_WORLD);
  state(archive);
  static_cast<void>(writer.commit(3));
}

/// Restores it from the newest valid checkpoint.
template <class State>
void restore(const std::filesystem::path& directory, const State& state) {
  const auto search = find_checkpoint(directory, identity, {}, MPI_COMM_WORLD);
  RestoringArchive archive(search.checkpoint.value(), MPI_COMM_WORLD);
  state(archive);
}

/// CRC-32 of the paths and contents of all datasets.
inline std::uint64_t digest(const std::filesystem::path& path) {
  const auto visit = [](hid_t file, const char* name, const auto* object, void* sum) -> herr_t {
    if (object->type == H5O_TYPE_DATASET) {
      const auto dataset = H5Dopen2(file, name, H5P_DEFAULT);
      const auto type = H5Dget_type(dataset), space = H5Dget_space(dataset);
      std::vector<Bytef> content(H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
      H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
      content.insert(content.end(), name, name + std::string(name).size());
      auto& total = *static_cast<uLong*>(sum);
      total = crc32_z(total, content.data(), content.size());
      H5Sclose(space);
      H5Tclose(type);
      H5Dclose(dataset);
    }
    return 0;
  };
  uLong sum = 0;
  const auto file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_GE(file, 0);
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, visit, &sum, H5O_INFO_BASIC);
  H5Fclose(file);
  return sum;
}

}  // namespace idiophone::results

#include "idiophone/run/results/frame_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"

namespace idiophone::results {

namespace {

std::string displacements_of(const std::string& body) {
  return fmt::format("/frames/{}/displacement", body);
}

/// @throws std::runtime_error where the numbers contradict each other
void check_mesh(const FramedBody& body, const hdf5::Dimensions& frames, std::size_t times) {
  const auto nodes = static_cast<hsize_t>(body.nodes.size() / 3);
  const auto inside = [&](std::int32_t node) { return node >= 0 && static_cast<hsize_t>(node) < nodes; };
  if (frames.size() != 3 || frames[0] < times || frames[1] != nodes || frames[2] != 3 ||
      !std::ranges::all_of(body.cells, inside)) {
    throw std::runtime_error(fmt::format("the mesh and the frames of body {} contradict each other", body.name));
  }
}

FramedBody read_body(hid_t file, const std::string& name) {
  const auto nodes = hdf5::open_dataset(file, fmt::format("/mesh/{}/nodes", name));
  const auto cells = hdf5::open_dataset(file, fmt::format("/mesh/{}/elements", name));
  const auto node_shape = hdf5::shape_of(nodes.id()), cell_shape = hdf5::shape_of(cells.id());
  if (node_shape.size() != 2 || node_shape[1] != 3 || cell_shape.size() != 2 || cell_shape[1] == 0) {
    throw std::runtime_error(fmt::format("the mesh of body {} has no nodes or no cells", name));
  }
  return {.name = name,
          .nodes = hdf5::read<double>(nodes.id(), hdf5::whole(nodes.id())),
          .cells = hdf5::read<std::int32_t>(cells.id(), hdf5::whole(cells.id())),
          .cell_nodes = static_cast<std::size_t>(cell_shape[1])};
}

}  // namespace

struct FrameReader::State {
  std::filesystem::path path;
  hdf5::Identifier file;
  std::vector<double> times;
  std::vector<FramedBody> bodies;

  explicit State(std::filesystem::path result) : path(std::move(result)) {
    files::read_within_limit(path, [&] { read(); });
  }

  void read() {
    file = hdf5::open_for_reading(path);
    files::check_format(file.id(), files::result_format, path);
    const std::string prefix = "/frames/";
    const std::string suffix = "/displacement";
    for (const std::string& name : hdf5::datasets_below(file.id(), "/frames")) {
      if (name == "/frames/time") {
        const auto dataset = hdf5::open_dataset(file.id(), name);
        times = hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()));
      } else if (name.ends_with(suffix)) {
        bodies.push_back(read_body(file.id(), name.substr(prefix.size(), name.size() - prefix.size() - suffix.size())));
      }
    }
    for (const FramedBody& body : bodies) {
      check_mesh(body, hdf5::shape_of(hdf5::open_dataset(file.id(), displacements_of(body.name)).id()), times.size());
    }
  }
};

FrameReader::FrameReader(const std::filesystem::path& result) : state_(std::make_unique<State>(result)) {}
FrameReader::FrameReader(FrameReader&&) noexcept = default;
FrameReader& FrameReader::operator=(FrameReader&&) noexcept = default;
FrameReader::~FrameReader() = default;

const std::vector<double>& FrameReader::times() const {
  return state_->times;
}

const std::vector<FramedBody>& FrameReader::bodies() const {
  return state_->bodies;
}

std::vector<float> FrameReader::displacement(std::size_t body, std::size_t frame) const {
  return files::read_within_limit(state_->path, [&] {
    const FramedBody& framed = state_->bodies.at(body);
    const auto dataset = hdf5::open_dataset(state_->file.id(), displacements_of(framed.name));
    return hdf5::read<float>(dataset.id(), {{frame, 0, 0}, {1, framed.nodes.size() / 3, 3}});
  });
}

}  // namespace idiophone::results

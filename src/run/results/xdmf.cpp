#include "xdmf.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/markup.hpp"

namespace idiophone::results {

namespace {

struct MeshOfBody {
  std::string name;
  hsize_t nodes = 0, cells = 0;
  int nodes_per_cell = 0;
  std::string topology;  ///< of a cell
};

/// What moves the meshes: a dataset [pictures x nodes x 3] for each body.
struct Pictures {
  std::string group;          ///< of the datasets: "/frames"
  std::string quantity;       ///< the datasets' name
  int precision = 4;          ///< bytes of a number
  std::vector<double> times;  ///< [pictures]
};

/// @throws std::runtime_error if it does not have two dimensions
hdf5::Dimensions shape_of_matrix(hid_t file, const std::string& path) {
  auto shape = hdf5::shape_of(hdf5::open_dataset(file, path).id());
  if (shape.size() != 2) {
    throw std::runtime_error(fmt::format("{} is no table", path));
  }
  return shape;
}

std::vector<MeshOfBody> read_bodies(hid_t file) {
  const std::string begin = "/mesh/", end = "/elements";
  std::vector<MeshOfBody> bodies;
  for (const auto& path : hdf5::datasets_below(file, "/mesh")) {
    if (path.ends_with(end)) {
      const auto name = path.substr(begin.size(), path.size() - begin.size() - end.size());
      const auto elements = shape_of_matrix(file, path);
      const auto nodes = shape_of_matrix(file, begin + name + "/nodes");
      const auto cell = static_cast<int>(elements[1]);
      bodies.push_back({name, nodes[0], elements[0], cell, element::drawn_with(cell).topology});
    }
  }
  return bodies;
}

/// Modes, whose numbers from 1 on replace times; frames if there are no modes.
Pictures read_pictures(hid_t file, const std::vector<MeshOfBody>& bodies) {
  const auto modes = hdf5::datasets_below(file, "/modes");
  if (!modes.empty()) {
    const auto frequency = hdf5::open_dataset(file, fmt::format("/modes/{}/frequency", bodies.front().name));
    Pictures pictures{"/modes", "shape", 8, hdf5::read<double>(frequency.id(), hdf5::whole(frequency.id()))};
    std::iota(pictures.times.begin(), pictures.times.end(), 1.0);
    return pictures;
  }
  const auto time = hdf5::open_dataset(file, "/frames/time");
  return {"/frames", "displacement", 4, hdf5::read<double>(time.id(), hdf5::whole(time.id()))};
}

/// One body in one picture; its mesh alone if there are no pictures.
std::string body_grid(const std::string& file, const MeshOfBody& body, const Pictures& pictures, std::size_t picture,
                      const std::string& time) {
  const auto name = in_markup(body.name);
  auto grid = fmt::format(
      R"(<Grid Name="{0}" GridType="Uniform">{1}
<Topology TopologyType="{2}" NumberOfElements="{3}"><DataItem Format="HDF" NumberType="Int" Precision="4" Dimensions="{3} {4}">{5}:/mesh/{0}/elements</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="{6} 3">{5}:/mesh/{0}/nodes</DataItem></Geometry>
)",
      name, time, body.topology, body.cells, body.nodes_per_cell, file, body.nodes);
  if (!pictures.times.empty()) {
    grid += fmt::format(
        R"(<Attribute Name="{5}" AttributeType="Vector" Center="Node"><DataItem ItemType="HyperSlab" Dimensions="{0} 3"><DataItem Format="XML" NumberType="Int" Dimensions="3 3">{1} 0 0 1 1 1 1 {0} 3</DataItem><DataItem Format="HDF" NumberType="Float" Precision="{7}" Dimensions="{2} {0} 3">{3}:{6}/{4}/{5}</DataItem></DataItem></Attribute>
)",
        body.nodes, picture, pictures.times.size(), file, name, pictures.quantity, pictures.group, pictures.precision);
  }
  return grid + "</Grid>\n";
}

/// All bodies in one picture.
std::string picture_grid(const std::string& file, const std::vector<MeshOfBody>& bodies, const Pictures& pictures,
                         std::size_t picture, double seconds) {
  const auto time = fmt::format(R"(<Time Value="{}"/>)", seconds);
  if (bodies.size() == 1) {
    return body_grid(file, bodies[0], pictures, picture, time);
  }
  auto grid = fmt::format(R"(<Grid Name="bodies" GridType="Collection" CollectionType="Spatial">{}
)",
                          time);
  for (const auto& body : bodies) {
    grid += body_grid(file, body, pictures, picture, "");
  }
  return grid + "</Grid>\n";
}

}  // namespace

std::filesystem::path write_xdmf(const std::filesystem::path& result) {
  std::vector<MeshOfBody> bodies;
  Pictures pictures;
  files::read_naming(result, [&] {
    const auto file = hdf5::open_for_reading(result);
    bodies = read_bodies(file.id());
    if (!bodies.empty()) {
      pictures = read_pictures(file.id(), bodies);
    }
  });
  if (bodies.empty()) {
    return {};
  }
  const auto relative = in_markup(result.filename().string());
  std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
<Domain>
<Grid Name="frames" GridType="Collection" CollectionType="Temporal">
)";
  for (std::size_t picture = 0; picture < pictures.times.size(); ++picture) {
    text += picture_grid(relative, bodies, pictures, picture, pictures.times[picture]);
  }
  if (pictures.times.empty()) {
    text += picture_grid(relative, bodies, pictures, 0, 0.0);
  }
  text += "</Grid>\n</Domain>\n</Xdmf>\n";
  auto path = result;
  files::write_atomically(path.replace_extension(".xdmf"), text);
  return path;
}

}  // namespace idiophone::results

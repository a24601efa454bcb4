#include "idiophone/store/xdmf.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "atomic_file.hpp"
#include "hdf5.hpp"

namespace idiophone::store {

namespace {

struct Body {
  std::string name;
  hsize_t nodes = 0, elements = 0, nodes_per_element = 0;
};

/// The five characters that mean something in XML.
std::string escape(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    switch (character) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&apos;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

std::vector<Body> read_bodies(hid_t file) {
  const std::string begin = "/mesh/", end = "/elements";
  std::vector<Body> bodies;
  for (const auto& path : hdf5::datasets_below(file, "/mesh")) {
    if (path.ends_with(end)) {
      const auto name = path.substr(begin.size(), path.size() - begin.size() - end.size());
      const auto elements = hdf5::shape_of(hdf5::open_dataset(file, path).id());
      const auto nodes = hdf5::shape_of(hdf5::open_dataset(file, begin + name + "/nodes").id());
      bodies.push_back({name, nodes.at(0), elements.at(0), elements.at(1)});
    }
  }
  return bodies;
}

/// One body at one time. XDMF's Tetrahedron_10 has VTK's order of nodes, which is ours.
std::string body_grid(const std::string& file, const Body& body, std::size_t frame, std::size_t frames,
                      const std::string& time) {
  const auto name = escape(body.name);
  auto grid = fmt::format(
      R"(<Grid Name="{0}" GridType="Uniform">{1}
<Topology TopologyType="{2}" NumberOfElements="{3}"><DataItem Format="HDF" NumberType="Int" Precision="4" Dimensions="{3} {4}">{5}:/mesh/{0}/elements</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="{6} 3">{5}:/mesh/{0}/nodes</DataItem></Geometry>
)",
      name, time, body.nodes_per_element == 4 ? "Tetrahedron" : "Tetrahedron_10", body.elements, body.nodes_per_element,
      file, body.nodes);
  if (frames > 0) {
    grid += fmt::format(
        R"(<Attribute Name="displacement" AttributeType="Vector" Center="Node"><DataItem ItemType="HyperSlab" Dimensions="{0} 3"><DataItem Format="XML" NumberType="Int" Dimensions="3 3">{1} 0 0 1 1 1 1 {0} 3</DataItem><DataItem Format="HDF" NumberType="Float" Precision="4" Dimensions="{2} {0} 3">{3}:/frames/{4}/displacement</DataItem></DataItem></Attribute>
)",
        body.nodes, frame, frames, file, name);
  }
  return grid + "</Grid>\n";
}

/// All bodies at one time.
std::string frame_grid(const std::string& file, const std::vector<Body>& bodies, std::size_t frame, std::size_t frames,
                       double seconds) {
  const auto time = fmt::format(R"(<Time Value="{}"/>)", seconds);
  if (bodies.size() == 1) {
    return body_grid(file, bodies[0], frame, frames, time);
  }
  auto grid = fmt::format(R"(<Grid Name="bodies" GridType="Collection" CollectionType="Spatial">{}
)",
                          time);
  for (const auto& body : bodies) {
    grid += body_grid(file, body, frame, frames, "");
  }
  return grid + "</Grid>\n";
}

}  // namespace

std::filesystem::path write_xdmf(const std::filesystem::path& result) {
  const auto file = hdf5::open_for_reading(result);
  const auto bodies = read_bodies(file.id());
  if (bodies.empty()) {
    return {};
  }
  const auto time = hdf5::open_dataset(file.id(), "/frames/time");
  auto times = hdf5::read<double>(time.id(), hdf5::whole(time.id()));
  const auto frames = times.size();
  if (frames == 0) {
    times.push_back(0.0);
  }
  const auto relative = escape(result.filename().string());
  std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
<Domain>
<Grid Name="frames" GridType="Collection" CollectionType="Temporal">
)";
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    text += frame_grid(relative, bodies, frame, frames, times[frame]);
  }
  text += "</Grid>\n</Domain>\n</Xdmf>\n";
  auto path = result;
  write_atomically(path.replace_extension(".xdmf"), text);
  return path;
}

}  // namespace idiophone::store

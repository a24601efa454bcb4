#include "radiation_xdmf.hpp"

#include <fmt/format.h>

namespace idiophone::harmonic {

namespace {

/// A scalar of each vertex: a slab of a dataset.
std::string attribute(const std::string& name, const std::string& slab, const std::string& whole,
                      std::size_t vertices) {
  return fmt::format(
      R"(<Attribute Name="{}" AttributeType="Scalar" Center="Node"><DataItem ItemType="HyperSlab" Dimensions="{}">{}{}</DataItem></Attribute>
)",
      name, vertices, slab, whole);
}

}  // namespace

std::string xdmf_text(const std::string& file, const Radiation& radiation) {
  const std::size_t vertices = radiation.surfaces.front().vertices.size();
  const std::size_t triangles = radiation.surfaces.front().triangles.size();
  const std::size_t sounds = radiation.sounds.size();
  const auto item = [&](const std::string& type, int precision, const std::string& shape, const std::string& path) {
    return fmt::format(R"(<DataItem Format="HDF" NumberType="{}" Precision="{}" Dimensions="{}">{}:{}</DataItem>)",
                       type, precision, shape, file, path);
  };
  std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
<Domain>
<Grid Name="sounds" GridType="Collection" CollectionType="Temporal">
)";
  for (std::size_t s = 0; s < sounds; ++s) {
    text += fmt::format(
        R"(<Grid Name="surface" GridType="Uniform"><Time Value="{}"/>
<Topology TopologyType="Triangle" NumberOfElements="{}">{}</Topology>
<Geometry GeometryType="XYZ">{}</Geometry>
)",
        s + 1, triangles, item("Int", 4, fmt::format("{} 3", triangles), "/surface/triangles"),
        item("Float", 8, fmt::format("{} 3", vertices), "/surface/vertices"));
    const auto slab = [&](const std::string& numbers, const std::string& dimensions) {
      return fmt::format(R"(<DataItem Format="XML" NumberType="Int" Dimensions="{}">{}</DataItem>)", dimensions,
                         numbers);
    };
    text += attribute("amplitude", slab(fmt::format("{} 0 1 1 1 {}", s, vertices), "3 2"),
                      item("Float", 8, fmt::format("{} {}", sounds, vertices), "/surface/amplitude"), vertices);
    for (const int part : {0, 1}) {
      text += attribute(part == 0 ? "real part" : "imaginary part",
                        slab(fmt::format("{} 0 {} 1 1 1 1 {} 1", s, part, vertices), "3 3"),
                        item("Float", 8, fmt::format("{} {} 2", sounds, vertices), "/surface/pressure"), vertices);
    }
    text += "</Grid>\n";
  }
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace idiophone::harmonic

#include "idiophone/air/harmonic/radiation_file.hpp"

#include <fmt/format.h>

#include <functional>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"

namespace idiophone::harmonic {

namespace {

class RadiationWriter {
 public:
  RadiationWriter(const std::filesystem::path& path, const Radiation& radiation)
      : file_(hdf5::create_file(path, MPI_COMM_SELF)), radiation_(radiation), count_(radiation.sounds.size()) {}

  void write(const Origin& origin) {
    files::write_origin(file_.id(), files::radiation_format, origin, MPI_COMM_SELF);
    hdf5::put(file_.id(), "body", radiation_.body);
    hdf5::put(file_.id(), "air_density", radiation_.air_density);
    hdf5::put(file_.id(), "air_speed", radiation_.air_speed);
    write_sounds();
    write_surface();
    write_listeners();
    write_directions();
    file_.close("can't write the radiated sound");
  }

 private:
  template <class T>
  void put(const std::string& path, const hdf5::Dimensions& shape, const std::vector<T>& values,
           const std::string& unit) {
    const auto dataset = hdf5::create_dataset(file_.id(), path, hdf5::type_of<T>(), shape);
    hdf5::write(dataset.id(), hdf5::whole(dataset.id()), std::span<const T>(values), hdf5::Transfer::alone);
    hdf5::put(dataset.id(), "unit", unit);
    hdf5::put(dataset.id(), files::checksum_attribute, std::int64_t{files::checksum(std::as_bytes(std::span(values)))});
  }

  void put(const std::string& path, const std::vector<Vector3>& points, const std::string& unit) {
    std::vector<double> coordinates;
    for (const Vector3& point : points) {
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    }
    put(path, {points.size(), 3}, coordinates, unit);
  }

  void put(const std::string& path, const std::string& unit, double RadiatedSound::*fact) {
    std::vector<double> values;
    for (const RadiatedSound& sound : radiation_.sounds) {
      values.push_back(sound.*fact);
    }
    put(path, {count_}, values, unit);
  }

  /// Real and imaginary parts, [sounds x width x 2].
  void put(const std::string& path, const std::string& unit, std::vector<std::complex<double>> RadiatedSound::*field,
           std::size_t width) {
    std::vector<double> parts;
    for (const RadiatedSound& sound : radiation_.sounds) {
      for (const auto& value : sound.*field) {
        parts.push_back(value.real());
        parts.push_back(value.imag());
      }
    }
    put(path, {count_, width, 2}, parts, unit);
  }

  void write_sounds() {
    std::vector<std::string> names;
    for (const RadiatedSound& sound : radiation_.sounds) {
      names.push_back(sound.name);
    }
    hdf5::put_dataset(file_.id(), "/sounds/name", names, MPI_COMM_SELF);
    put("/sounds/frequency", "Hz", &RadiatedSound::frequency);
    put("/sounds/mean_square_velocity", "m2/s2", &RadiatedSound::mean_square_velocity);
    put("/sounds/power", "W", &RadiatedSound::power);
    put("/sounds/level_error", "dB", &RadiatedSound::level_error);
    put("/sounds/efficiency", "1", &RadiatedSound::efficiency);
    put("/sounds/loss_factor", "1", &RadiatedSound::loss_factor);
    put("/sounds/directivity_index", "dB", &RadiatedSound::directivity_index);
    put("/sounds/kirchhoff_error", "dB", &RadiatedSound::kirchhoff_error);
    put("/sounds/kirchhoff_worst", "dB", &RadiatedSound::kirchhoff_worst);
    put("/sounds/rayleigh_error", "dB", &RadiatedSound::rayleigh_error);
    put("/sounds/rayleigh_worst", "dB", &RadiatedSound::rayleigh_worst);
    if (radiation_.cell > 0.0) {
      hdf5::put(file_.id(), "waves_cell", radiation_.cell);
      put("/sounds/waves_error", "dB", &RadiatedSound::waves_error);
      put("/sounds/waves_worst", "dB", &RadiatedSound::waves_worst);
    }
  }

  void write_surface() {
    std::vector<std::int32_t> corners;
    for (const auto& triangle : radiation_.triangles) {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    std::vector<double> amplitudes;
    for (const RadiatedSound& sound : radiation_.sounds) {
      for (const auto& pressure : sound.surface_pressure) {
        amplitudes.push_back(std::abs(pressure));
      }
    }
    hdf5::put_dataset(file_.id(), "/surface/parts", radiation_.parts, MPI_COMM_SELF);
    put("/surface/first_triangle", {radiation_.first_triangle.size()}, radiation_.first_triangle, "1");
    put("/surface/vertices", radiation_.vertices, "m");
    put("/surface/triangles", {radiation_.triangles.size(), 3}, corners, "1");
    put("/surface/pressure", "Pa", &RadiatedSound::surface_pressure, radiation_.vertices.size());
    put("/surface/amplitude", {count_, radiation_.vertices.size()}, amplitudes, "Pa");
  }

  void write_listeners() {
    if (radiation_.listener_names.empty()) {
      return;
    }
    hdf5::put_dataset(file_.id(), "/listeners/name", radiation_.listener_names, MPI_COMM_SELF);
    put("/listeners/position", radiation_.listener_positions, "m");
    put("/listeners/pressure", "Pa", &RadiatedSound::listener_pressure, radiation_.listener_names.size());
  }

  void write_directions() {
    put("/sphere/direction", radiation_.directions, "1");
    put("/sphere/weight", {radiation_.weights.size()}, radiation_.weights, "sr");
    put("/sphere/pressure", "Pa m", &RadiatedSound::far_field, radiation_.directions.size());
    const auto dataset = hdf5::open_dataset(file_.id(), "/sphere/direction");
    hdf5::put(dataset.id(), "rings", radiation_.rings);
    hdf5::put(dataset.id(), "azimuths", 2 * radiation_.rings);
  }

  hdf5::Identifier file_;
  const Radiation& radiation_;
  hsize_t count_;
};

/// A scalar of each vertex: a slab of a dataset.
std::string attribute(const std::string& name, const std::string& slab, const std::string& whole,
                      std::size_t vertices) {
  return fmt::format(
      R"(<Attribute Name="{}" AttributeType="Scalar" Center="Node"><DataItem ItemType="HyperSlab" Dimensions="{}">{}{}</DataItem></Attribute>
)",
      name, vertices, slab, whole);
}

/// The sounds take the place of time by their numbers, from 1 on.
std::string xdmf_text(const std::string& file, const Radiation& radiation) {
  const std::size_t vertices = radiation.vertices.size();
  const std::size_t triangles = radiation.triangles.size();
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

}  // namespace

void write_radiation(const std::filesystem::path& path, const Origin& origin, const Radiation& radiation) {
  auto part = path;
  part += ".part";
  RadiationWriter(part, radiation).write(origin);
  files::synchronise(part);
  files::rename_durably(part, path);
  auto xdmf = path;
  files::write_atomically(xdmf.replace_extension(".xdmf"), xdmf_text(path.filename().string(), radiation));
}

}  // namespace idiophone::harmonic

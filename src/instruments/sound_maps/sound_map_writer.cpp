#include <algorithm>
#include <string>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "sound_map_paths.hpp"

namespace idiophone::sound_maps {

namespace {

/// Three coordinates of each point, one after the other.
std::vector<double> coordinates(std::span<const Vector3> points) {
  std::vector<double> all;
  for (const Vector3& point : points) {
    all.insert(all.end(), point.begin(), point.end());
  }
  return all;
}

/// Real and imaginary part of each number, one after the other.
void append_parts(std::vector<double>& parts, std::complex<double> number) {
  parts.push_back(number.real());
  parts.push_back(number.imag());
}

class MapWriter {
 public:
  MapWriter(const std::filesystem::path& path, const SoundMap& map)
      : file_(hdf5::create_file(path, MPI_COMM_SELF)), map_(map) {}

  void write() {
    files::write_origin(file_.id(), files::sound_map_format,
                        {map_.name, map_.code_version, map_.deck_text, map_.overrides}, MPI_COMM_SELF);
    hdf5::put_dataset(file_.id(), sound_map::resolved_deck, {map_.resolved_deck}, MPI_COMM_SELF);
    write_facts();
    write_modes();
    write_scaling();
    write_stretching();
    write_surface();
    write_listeners();
    write_sphere();
    file_.close("can't write the sound map");
  }

 private:
  template <class T>
  void write(const std::string& path, const hdf5::Dimensions& shape, const std::vector<T>& values,
             const std::string& unit) {
    const auto dataset = hdf5::create_dataset(file_.id(), path, hdf5::type_of<T>(), shape);
    hdf5::write(dataset.id(), hdf5::whole(dataset.id()), std::span<const T>(values), hdf5::Transfer::alone);
    hdf5::put(dataset.id(), "unit", unit);
    hdf5::put(dataset.id(), files::checksum_attribute, std::int64_t{files::checksum(std::as_bytes(std::span(values)))});
  }

  void write_facts() {
    const hid_t file = file_.id();
    hdf5::put(file, "body", map_.body);
    hdf5::put(file, "kind", map_.kind);
    hdf5::put(file, "mass", map_.mass);
    hdf5::put(file, "centre", std::vector<std::array<double, 3>>{{map_.centre[0], map_.centre[1], map_.centre[2]}});
    hdf5::put(file, "air_density", map_.air_density);
    hdf5::put(file, "air_speed", map_.air_speed);
    hdf5::put(file, "radiation", map_.radiation);
    if (const auto& material = map_.material) {
      hdf5::put(file, "material", material->name);
      hdf5::put(file, "density", material->density);
      hdf5::put(file, "young", material->young);
      hdf5::put(file, "poisson", material->poisson);
    }
  }

  void write_modes() {
    const hsize_t modes = map_.modes();
    std::vector<double> decay;
    for (std::size_t mode = 0; mode < modes; ++mode) {
      decay.push_back(map_.decay(mode));
    }
    write(sound_map::frequency, {modes}, map_.frequency, "Hz");
    write(sound_map::decay, {modes}, decay, "1/s");
    write(sound_map::material_decay, {modes}, map_.material_decay, "1/s");
    write(sound_map::radiation_decay, {modes}, map_.radiation_decay, "1/s");
    if (!map_.mesh_error.empty()) {
      write(sound_map::mesh_error, {modes}, map_.mesh_error, "cents");
    }
    write(sound_map::shape, {modes, map_.vertices.size(), 3}, map_.shape, "1/sqrt(kg)");
  }

  void write_scaling() {
    if (const auto& scalable = map_.scalable) {
      const auto& stiffness = scalable->stiffness.reshaped();  // symmetric, so rows are columns
      write(sound_map::stiffness, {6, 6}, std::vector<double>(stiffness.begin(), stiffness.end()), "Pa");
      write(sound_map::lossless_frequency, {map_.modes()}, scalable->lossless_frequency, "Hz");
      const auto group = hdf5::open_group(file_.id(), sound_map::scaling);
      hdf5::put(group.id(), "mesh_hash", scalable->mesh);
      hdf5::put(group.id(), "held", scalable->held);
      if (scalable->mesh_shape) {
        write_mesh_shape(*scalable->mesh_shape);
      }
    }
  }

  void write_mesh_shape(const MeshShape& shape) {
    Eigen::Matrix<double, 7, 4, Eigen::RowMajor> rows;
    rows << shape.middle.transpose(), shape.size, shape.pattern;
    write(sound_map::mesh_shape, {7, 4}, std::vector<double>(rows.data(), rows.data() + rows.size()), "m, 1");
    hdf5::put(hdf5::open_dataset(file_.id(), sound_map::mesh_shape).id(), "mesh", shape.kind);
  }

  void write_stretching() {
    const modal_bodies::Stretching& stretching = map_.stretching;
    if (!stretching.exists()) {
      return;
    }
    const hsize_t modes = map_.modes(), terms = stretching.terms();
    write(sound_map::stretching_linear, {terms, modes}, stretching.linear, "sqrt(J)/(m sqrt(kg))");
    write(sound_map::stretching_quadratic, {terms, modes, modes}, stretching.quadratic, "sqrt(J)/(m2 kg)");
    write(sound_map::stretching_rotation, {modes, modes}, stretching.rotation, "1/(m2 kg)");
    const auto group = hdf5::open_group(file_.id(), sound_map::stretching);
    hdf5::put(group.id(), "version", sound_map::stretching_version);
  }

  void write_surface() {
    std::vector<std::int32_t> corners;
    for (const auto& triangle : map_.triangles) {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    write(sound_map::vertices, {map_.vertices.size(), 3}, coordinates(map_.vertices), "m");
    write(sound_map::triangles, {map_.triangles.size(), 3}, corners, "1");
  }

  void write_listeners() {
    const hsize_t count = map_.listeners.size();
    std::vector<std::string> names;
    std::vector<Vector3> positions;
    std::vector<double> delays;
    std::vector<double> parts;
    for (const MapListener& listener : map_.listeners) {
      names.push_back(listener.name);
      positions.push_back(listener.position);
      delays.push_back(listener.delay);
    }
    for (std::size_t mode = 0; mode < map_.modes(); ++mode) {
      for (const MapListener& listener : map_.listeners) {
        append_parts(parts, listener.pressure[mode]);
      }
    }
    hdf5::put_dataset(file_.id(), sound_map::listener_names, names, MPI_COMM_SELF);
    write(sound_map::listener_positions, {count, 3}, coordinates(positions), "m");
    write(sound_map::listener_delays, {count}, delays, "s");
    write(sound_map::listener_pressure, {map_.modes(), count, 2}, parts, pressure_unit);
  }

  void write_sphere() {
    const MapSphere& sphere = map_.sphere;
    const hsize_t count = sphere.direction.size();
    std::vector<double> parts;
    for (const auto& pressure : sphere.pressure) {
      append_parts(parts, pressure);
    }
    write(sound_map::directions, {count, 3}, coordinates(sphere.direction), "1");
    write(sound_map::weights, {count}, sphere.weight, "sr");
    write(sound_map::sphere_pressure, {map_.modes(), count, 2}, parts, pressure_unit);
    const auto dataset = hdf5::open_dataset(file_.id(), sound_map::directions);
    hdf5::put(dataset.id(), "distance", sphere.distance);
    hdf5::put(dataset.id(), "rings", static_cast<std::int64_t>(sphere.rings));
    hdf5::put(dataset.id(), "azimuths", static_cast<std::int64_t>(sphere.azimuths));
  }

  static constexpr const char* pressure_unit = "Pa s/(m sqrt(kg))";

  hdf5::Identifier file_;
  const SoundMap& map_;
};

}  // namespace

void write_sound_map(const std::filesystem::path& path, const SoundMap& map) {
  check_sound_map(map, path);
  auto part = path;
  part += ".part";
  MapWriter(part, map).write();
  files::synchronise(part);
  files::rename_durably(part, path);
}

}  // namespace idiophone::sound_maps

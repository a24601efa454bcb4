#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/verification.hpp"
#include "sound_map_paths.hpp"

namespace idiophone::sound_maps {

namespace {

class MapReader {
 public:
  explicit MapReader(const std::filesystem::path& path) : path_(path), file_(hdf5::open_for_reading(path)) {
    files::check_format(file_.id(), files::sound_map_format, path);
  }

  SoundMap read() {
    read_facts();
    map_.frequency = values<double>(sound_map::frequency, {any});
    const hsize_t modes = map_.modes();
    map_.material_decay = values<double>(sound_map::material_decay, {modes});
    map_.radiation_decay = values<double>(sound_map::radiation_decay, {modes});
    if (hdf5::exists(file_.id(), sound_map::mesh_error)) {
      map_.mesh_error = values<double>(sound_map::mesh_error, {modes});
    }
    read_scaling();
    read_stretching();
    read_surface();
    map_.shape = values<float>(sound_map::shape, {modes, map_.vertices.size(), 3});
    read_listeners();
    read_sphere();
    check_sound_map(map_, path_);
    return std::move(map_);
  }

 private:
  static constexpr hsize_t any = 0;  ///< in a shape: of any size

  /// @param expected  shape
  template <class T>
  std::vector<T> values(const std::string& name, const hdf5::Dimensions& expected) {
    const auto dataset = hdf5::open_dataset(file_.id(), name);
    const auto shape = hdf5::shape_of(dataset.id());
    bool right = shape.size() == expected.size();
    for (std::size_t i = 0; right && i < shape.size(); ++i) {
      right = expected[i] == any || shape[i] == expected[i];
    }
    if (!right) {
      throw std::runtime_error(
          fmt::format("{} is no right sound map: {} does not have the size of the others", path_.string(), name));
    }
    return hdf5::read<T>(dataset.id(), hdf5::whole(dataset.id()));
  }

  std::vector<Vector3> points(const std::string& name) {
    const auto numbers = values<double>(name, {any, 3});
    std::vector<Vector3> points(numbers.size() / 3);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      points[i / 3][static_cast<Eigen::Index>(i % 3)] = numbers[i];
    }
    return points;
  }

  std::vector<std::complex<double>> complex_values(const std::string& name, hsize_t columns) {
    const auto parts = values<double>(name, {map_.modes(), columns, 2});
    std::vector<std::complex<double>> numbers(parts.size() / 2);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = {parts[2 * i], parts[2 * i + 1]};
    }
    return numbers;
  }

  void read_facts() {
    const hid_t file = file_.id();
    map_.name = hdf5::text_of(file, "name");
    map_.code_version = hdf5::text_of(file, "code_version");
    map_.deck_text = hdf5::text_in(file, "/deck");
    map_.overrides = hdf5::texts_in(file, "/overrides");
    map_.resolved_deck = hdf5::text_in(file, sound_map::resolved_deck);
    map_.body = hdf5::text_of(file, "body");
    map_.kind = hdf5::text_of(file, "kind");
    map_.mass = hdf5::number_of(file, "mass");
    const auto centre = hdf5::points_of(file, "centre");
    if (centre.size() != 1) {
      throw std::runtime_error(fmt::format("{} is no right sound map: centre is not one point", path_.string()));
    }
    map_.centre = Vector3::Map(centre[0].data());
    map_.air_density = hdf5::number_of(file, "air_density");
    map_.air_speed = hdf5::number_of(file, "air_speed");
    map_.radiation = hdf5::text_of(file, "radiation");
    if (hdf5::has(file, "material")) {
      map_.material = MapMaterial{.name = hdf5::text_of(file, "material"),
                                  .density = hdf5::number_of(file, "density"),
                                  .young = hdf5::number_of(file, "young"),
                                  .poisson = hdf5::number_of(file, "poisson")};
    }
  }

  std::optional<MeshShape> mesh_shape() {
    if (!hdf5::exists(file_.id(), sound_map::mesh_shape)) {
      return {};
    }
    const auto dataset = hdf5::open_dataset(file_.id(), sound_map::mesh_shape);
    const auto rows = values<double>(sound_map::mesh_shape, {7, 4});
    return MeshShape{.kind = hdf5::text_of(dataset.id(), "mesh"),
                     .middle = Vector3::Map(rows.data()),
                     .size = rows[3],
                     .pattern = Eigen::Matrix<double, 6, 4, Eigen::RowMajor>::Map(rows.data() + 4)};
  }

  void read_scaling() {
    if (!hdf5::exists(file_.id(), sound_map::scaling)) {
      return;
    }
    const auto group = hdf5::open_group(file_.id(), sound_map::scaling);
    const auto stiffness = values<double>(sound_map::stiffness, {6, 6});
    map_.scalable = ScalableModes{
        .mesh = hdf5::text_of(group.id(), "mesh_hash"),
        .mesh_shape = mesh_shape(),
        .held = hdf5::text_of(group.id(), "held"),
        .stiffness = ScalableModes::Stiffness::Map(stiffness.data()),
        .lossless_frequency = values<double>(sound_map::lossless_frequency, {map_.modes()}),
    };
  }

  void read_stretching() {
    if (!hdf5::exists(file_.id(), sound_map::stretching)) {
      return;
    }
    const auto group = hdf5::open_group(file_.id(), sound_map::stretching);
    if (const auto version = hdf5::integer_of(group.id(), "version"); version != sound_map::stretching_version) {
      throw std::runtime_error(fmt::format("{} has version {} of the stretching; this program knows version {}",
                                           path_.string(), version, sound_map::stretching_version));
    }
    const hsize_t modes = map_.modes();
    map_.stretching.linear = values<double>(sound_map::stretching_linear, {any, modes});
    const hsize_t terms = map_.stretching.linear.size() / modes;
    map_.stretching.quadratic = values<double>(sound_map::stretching_quadratic, {terms, modes, modes});
    map_.stretching.rotation = values<double>(sound_map::stretching_rotation, {modes, modes});
  }

  void read_surface() {
    map_.vertices = points(sound_map::vertices);
    const auto corners = values<std::int32_t>(sound_map::triangles, {any, 3});
    map_.triangles.resize(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      map_.triangles[i / 3][i % 3] = corners[i];
    }
  }

  void read_listeners() {
    const auto names = hdf5::texts_in(file_.id(), sound_map::listener_names);
    const auto positions = points(sound_map::listener_positions);
    const auto delays = values<double>(sound_map::listener_delays, {positions.size()});
    const auto pressure = complex_values(sound_map::listener_pressure, positions.size());
    if (names.size() != positions.size()) {
      throw std::runtime_error(fmt::format("{} is no right sound map: {} listeners have names, and {} have positions",
                                           path_.string(), names.size(), positions.size()));
    }
    for (std::size_t l = 0; l < names.size(); ++l) {
      MapListener& listener = map_.listeners.emplace_back();
      listener.name = names[l];
      listener.position = positions[l];
      listener.delay = delays[l];
      for (std::size_t mode = 0; mode < map_.modes(); ++mode) {
        listener.pressure.push_back(pressure[mode * names.size() + l]);
      }
    }
  }

  void read_sphere() {
    MapSphere& sphere = map_.sphere;
    sphere.direction = points(sound_map::directions);
    sphere.weight = values<double>(sound_map::weights, {sphere.direction.size()});
    sphere.pressure = complex_values(sound_map::sphere_pressure, sphere.direction.size());
    const auto dataset = hdf5::open_dataset(file_.id(), sound_map::directions);
    sphere.distance = hdf5::number_of(dataset.id(), "distance");
    sphere.rings = static_cast<std::size_t>(hdf5::integer_of(dataset.id(), "rings"));
    sphere.azimuths = static_cast<std::size_t>(hdf5::integer_of(dataset.id(), "azimuths"));
  }

  const std::filesystem::path& path_;
  hdf5::Identifier file_;
  SoundMap map_;
};

}  // namespace

SoundMap read_sound_map(const std::filesystem::path& path) {
  results::require_intact(path);
  return files::read_within_limit(path, [&] { return MapReader(path).read(); });
}

}  // namespace idiophone::sound_maps

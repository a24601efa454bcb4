#include "idiophone/air/harmonic/radiation_file.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "radiation_paths.hpp"
#include "radiation_xdmf.hpp"
#include "sound_facts.hpp"

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
    hdf5::put(file_.id(), radiation_paths::bodies, static_cast<std::int64_t>(radiation_.bodies));
    write_sounds();
    write_surface();
    write_solutions();
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

  void put(const SoundFact& fact) {
    std::vector<double> values;
    for (const RadiatedSound& sound : radiation_.sounds) {
      values.push_back(sound.*fact.value);
    }
    put(fact.path, {count_}, values, fact.unit);
  }

  /// Real and imaginary parts of the first numbers of each field, [fields x width x 2].
  void put(const std::string& path, const std::string& unit, const std::vector<const std::vector<Complex>*>& fields,
           std::size_t width) {
    std::vector<double> parts;
    for (const std::vector<Complex>* field : fields) {
      for (const Complex value : std::span(*field).first(width)) {
        parts.push_back(value.real());
        parts.push_back(value.imag());
      }
    }
    put(path, {fields.size(), width, 2}, parts, unit);
  }

  /// One field of each sound.
  template <class Field>
  [[nodiscard]] std::vector<const std::vector<Complex>*> of_sounds(const Field& field) const {
    std::vector<const std::vector<Complex>*> fields;
    for (const RadiatedSound& sound : radiation_.sounds) {
      fields.push_back(&field(sound));
    }
    return fields;
  }

  void put_surface(const std::string& group, const Boundary& surface) {
    std::vector<std::int32_t> corners;
    for (const auto& triangle : surface.triangles) {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    put(group + "/vertices", surface.vertices, "m");
    put(group + "/triangles", {surface.triangles.size(), 3}, corners, "1");
  }

  void write_sounds() {
    std::vector<std::string> names;
    for (const RadiatedSound& sound : radiation_.sounds) {
      names.push_back(sound.name);
    }
    hdf5::put_dataset(file_.id(), radiation_paths::names, names, MPI_COMM_SELF);
    std::ranges::for_each(sound_facts, [&](const SoundFact& fact) { put(fact); });
    if (radiation_.cell > 0.0) {
      hdf5::put(file_.id(), radiation_paths::cell, radiation_.cell);
      std::ranges::for_each(waves_facts, [&](const SoundFact& fact) { put(fact); });
    }
  }

  void write_surface() {
    const Boundary& surface = radiation_.surfaces.front();
    const std::size_t vertices = surface.vertices.size();
    std::vector<double> amplitudes;
    for (const RadiatedSound& sound : radiation_.sounds) {
      for (const Complex pressure : std::span(sound.solution.pressure).first(vertices)) {
        amplitudes.push_back(std::abs(pressure));
      }
    }
    hdf5::put_dataset(file_.id(), radiation_paths::parts, radiation_.parts, MPI_COMM_SELF);
    put(radiation_paths::first_triangle, {radiation_.first_triangle.size()}, radiation_.first_triangle, "1");
    put_surface("/surface", surface);
    put("/surface/pressure", "Pa",
        of_sounds([](const RadiatedSound& sound) -> const auto& { return sound.solution.pressure; }), vertices);
    put("/surface/amplitude", {count_, vertices}, amplitudes, "Pa");
    if (const auto& floor = surface.floor) {
      hdf5::put(file_.id(), radiation_paths::floor_at, rows(floor->at));
      hdf5::put(file_.id(), radiation_paths::floor_normal, rows(floor->normal));
      hdf5::put(file_.id(), radiation_paths::floor_reflection, floor->reflection);
    }
  }

  /// The surfaces that sounds were solved on, each with the solutions of its sounds.
  void write_solutions() {
    for (std::size_t level = 0; level < radiation_.surfaces.size(); ++level) {
      std::vector<std::int32_t> numbers;
      std::vector<const std::vector<Complex>*> pressures, velocities;
      for (std::size_t s = 0; s < radiation_.sounds.size(); ++s) {
        if (const RadiatedSound& sound = radiation_.sounds[s]; sound.refinements == level) {
          numbers.push_back(static_cast<std::int32_t>(s));
          pressures.push_back(&sound.solution.pressure);
          velocities.push_back(&sound.solution.normal_velocity);
        }
      }
      if (numbers.empty()) {
        continue;
      }
      const Boundary& surface = radiation_.surfaces[level];
      const std::string group = radiation_paths::solutions(level);
      put_surface(group, surface);
      put(group + "/sound", {numbers.size()}, numbers, "1");
      put(group + "/pressure", "Pa", pressures, surface.vertices.size());
      put(group + "/normal_velocity", "m/s", velocities, 3 * surface.triangles.size());
    }
  }

  void write_listeners() {
    if (radiation_.listener_names.empty()) {
      return;
    }
    hdf5::put_dataset(file_.id(), radiation_paths::listener_names, radiation_.listener_names, MPI_COMM_SELF);
    put(radiation_paths::listener_positions, radiation_.listener_positions, "m");
    put(radiation_paths::listener_pressure, "Pa",
        of_sounds([](const RadiatedSound& sound) -> const auto& { return sound.listener_pressure; }),
        radiation_.listener_names.size());
  }

  void write_directions() {
    put(radiation_paths::directions, radiation_.directions, "1");
    put(radiation_paths::weights, {radiation_.weights.size()}, radiation_.weights, "sr");
    put(radiation_paths::far_field, "Pa m",
        of_sounds([](const RadiatedSound& sound) -> const auto& { return sound.far_field; }),
        radiation_.directions.size());
    const auto dataset = hdf5::open_dataset(file_.id(), radiation_paths::directions);
    hdf5::put(dataset.id(), "rings", radiation_.rings);
    hdf5::put(dataset.id(), "azimuths", 2 * radiation_.rings);
  }

  static std::vector<std::array<double, 3>> rows(const Vector3& point) { return {{point.x(), point.y(), point.z()}}; }

  hdf5::Identifier file_;
  const Radiation& radiation_;
  hsize_t count_;
};

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

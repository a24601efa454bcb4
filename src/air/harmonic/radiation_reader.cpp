#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "idiophone/air/harmonic/radiation_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "radiation_paths.hpp"
#include "sound_facts.hpp"

namespace idiophone::harmonic {

namespace {

class RadiationReader {
 public:
  explicit RadiationReader(const std::filesystem::path& path) : file_(hdf5::open_for_reading(path)) {
    files::check_format(file_.id(), files::radiation_format, path);
  }

  StoredRadiation read() {
    const hid_t file = file_.id();
    require(hdf5::exists(file, radiation_paths::all_solutions),
            "has no /solutions, as files of older versions; run radiate on its deck again");
    radiation_.body = hdf5::text_of(file, "body");
    radiation_.bodies = static_cast<std::size_t>(hdf5::integer_of(file, radiation_paths::bodies));
    radiation_.air_density = hdf5::number_of(file, "air_density");
    radiation_.air_speed = hdf5::number_of(file, "air_speed");
    require(radiation_.air_density > 0 && radiation_.air_speed > 0, "has an air without density or speed of sound");
    read_sounds();
    read_surface();
    read_solutions();
    read_listeners();
    read_directions();
    return {.origin = {.name = hdf5::text_of(file, "name"),
                       .code_version = hdf5::text_of(file, "code_version"),
                       .deck_text = hdf5::text_in(file, "/deck"),
                       .overrides = hdf5::texts_in(file, "/overrides")},
            .radiation = std::move(radiation_)};
  }

 private:
  static void require(bool good, const std::string& problem) {
    if (!good) {
      throw std::runtime_error(problem);
    }
  }

  static constexpr hsize_t any = std::numeric_limits<hsize_t>::max();  ///< in a shape: of any size but 0

  /// @param expected  shape
  template <class T>
  std::vector<T> values(const std::string& name, const hdf5::Dimensions& expected) {
    const auto dataset = hdf5::open_dataset(file_.id(), name);
    const auto fits = [](hsize_t size, hsize_t wanted) { return wanted == any ? size > 0 : size == wanted; };
    require(std::ranges::equal(hdf5::shape_of(dataset.id()), expected, fits),
            fmt::format("{} does not have the size of the others", name));
    return hdf5::read<T>(dataset.id(), hdf5::whole(dataset.id()));
  }

  std::vector<Vector3> points(const std::string& name) {
    const auto numbers = values<double>(name, {any, 3});
    std::vector<Vector3> points;
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return points;
  }

  /// [rows][width], from [rows x width x 2] real and imaginary parts.
  std::vector<std::vector<Complex>> fields(const std::string& name, std::size_t rows, std::size_t width) {
    const auto parts = values<double>(name, {rows, width, 2});
    require(std::ranges::all_of(parts, [](double part) { return std::isfinite(part); }),
            fmt::format("{} has a number that is not finite", name));
    std::vector<std::vector<Complex>> fields(rows);
    for (std::size_t i = 0; i < parts.size(); i += 2) {
      fields[i / (2 * width)].emplace_back(parts[i], parts[i + 1]);
    }
    return fields;
  }

  void read_sounds() {
    for (const std::string& name : hdf5::texts_in(file_.id(), radiation_paths::names)) {
      radiation_.sounds.emplace_back().name = name;
    }
    require(!radiation_.sounds.empty(), "has no sounds");
    std::ranges::for_each(sound_facts, [&](const SoundFact& fact) { read(fact); });
    if (hdf5::has(file_.id(), radiation_paths::cell)) {
      radiation_.cell = hdf5::number_of(file_.id(), radiation_paths::cell);
      std::ranges::for_each(waves_facts, [&](const SoundFact& fact) { read(fact); });
    }
  }

  void read(const SoundFact& fact) {
    const auto numbers = values<double>(fact.path, {radiation_.sounds.size()});
    for (std::size_t s = 0; s < numbers.size(); ++s) {
      radiation_.sounds[s].*fact.value = numbers[s];
    }
  }

  Boundary surface(const std::string& group) {
    Boundary surface{.vertices = points(group + "/vertices"), .triangles = {}, .floor = floor_};
    const auto corners = values<std::int32_t>(group + "/triangles", {any, 3});
    surface.triangles.resize(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      require(corners[i] >= 0 && corners[i] < std::ssize(surface.vertices),
              fmt::format("{}/triangles names vertex {}; there are {}", group, corners[i], surface.vertices.size()));
      surface.triangles[i / 3].at(i % 3) = corners[i];
    }
    return surface;
  }

  void read_surface() {
    if (hdf5::has(file_.id(), radiation_paths::floor_at)) {
      floor_ = radiation::ReflectingPlane{.at = point(radiation_paths::floor_at),
                                          .normal = point(radiation_paths::floor_normal),
                                          .reflection = hdf5::number_of(file_.id(), radiation_paths::floor_reflection)};
    }
    radiation_.surfaces = {surface("/surface")};
    radiation_.parts = hdf5::texts_in(file_.id(), radiation_paths::parts);
    radiation_.first_triangle = values<std::int32_t>(radiation_paths::first_triangle, {radiation_.parts.size() + 1});
    require(radiation_.bodies <= radiation_.parts.size() && std::ranges::is_sorted(radiation_.first_triangle) &&
                radiation_.first_triangle.front() == 0 &&
                radiation_.first_triangle.back() == std::ssize(radiation_.surfaces.front().triangles),
            fmt::format("{} does not divide its triangles", radiation_paths::first_triangle));
  }

  Vector3 point(const char* attribute) {
    const auto points = hdf5::points_of(file_.id(), attribute);
    require(points.size() == 1, fmt::format("{} is not one point", attribute));
    return Vector3::Map(points.front().data());
  }

  void read_solutions() {
    constexpr std::size_t most_refinements = 16;  // four times the triangles each
    std::size_t solved = 0;
    for (std::size_t refinements = 0; refinements <= most_refinements; ++refinements) {
      if (hdf5::exists(file_.id(), radiation_paths::solutions(refinements))) {
        solved += read_solutions(refinements);
      }
    }
    require(solved == radiation_.sounds.size(),
            fmt::format("has solutions of {} sounds; there are {}", solved, radiation_.sounds.size()));
  }

  /// @return of how many sounds
  std::size_t read_solutions(std::size_t refinements) {
    const std::string group = radiation_paths::solutions(refinements);
    radiation_.surfaces.resize(std::max(radiation_.surfaces.size(), refinements + 1));
    const Boundary& surface = radiation_.surfaces[refinements] = this->surface(group);
    require(surface.vertices.size() >= radiation_.surfaces.front().vertices.size(),
            fmt::format("{} has fewer vertices than /surface", group));
    const auto numbers = values<std::int32_t>(group + "/sound", {any});
    auto pressures = fields(group + "/pressure", numbers.size(), surface.vertices.size());
    auto velocities = fields(group + "/normal_velocity", numbers.size(), 3 * surface.triangles.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      require(numbers[i] >= 0 && numbers[i] < std::ssize(radiation_.sounds),
              fmt::format("{}/sound names sound {}; there are {}", group, numbers[i], radiation_.sounds.size()));
      RadiatedSound& sound = radiation_.sounds[numbers[i]];
      require(sound.solution.pressure.empty(), fmt::format("{}/sound names sound {} again", group, numbers[i]));
      sound.refinements = refinements;
      sound.solution = {.wave_number = 2.0 * std::numbers::pi * sound.frequency / radiation_.air_speed,
                        .pressure = std::move(pressures[i]),
                        .normal_velocity = std::move(velocities[i]),
                        .power = sound.power};
    }
    return numbers.size();
  }

  void read_listeners() {
    if (!hdf5::exists(file_.id(), radiation_paths::listener_names)) {
      return;
    }
    radiation_.listener_names = hdf5::texts_in(file_.id(), radiation_paths::listener_names);
    require(!radiation_.listener_names.empty(), fmt::format("{} is empty", radiation_paths::listener_names));
    radiation_.listener_positions = points(radiation_paths::listener_positions);
    require(radiation_.listener_names.size() == radiation_.listener_positions.size(),
            fmt::format("{} does not have the size of the others", radiation_paths::listener_positions));
    read(radiation_paths::listener_pressure, radiation_.listener_names.size(), &RadiatedSound::listener_pressure);
  }

  void read_directions() {
    radiation_.directions = points(radiation_paths::directions);
    radiation_.weights = values<double>(radiation_paths::weights, {radiation_.directions.size()});
    radiation_.rings = hdf5::integer_of(hdf5::open_dataset(file_.id(), radiation_paths::directions).id(), "rings");
    read(radiation_paths::far_field, radiation_.directions.size(), &RadiatedSound::far_field);
  }

  void read(const char* path, std::size_t width, std::vector<Complex> RadiatedSound::*field) {
    auto read = fields(path, radiation_.sounds.size(), width);
    for (std::size_t s = 0; s < read.size(); ++s) {
      radiation_.sounds[s].*field = std::move(read[s]);
    }
  }

  hdf5::Identifier file_;
  std::optional<radiation::ReflectingPlane> floor_;
  Radiation radiation_;
};

}  // namespace

StoredRadiation read_radiation(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return RadiationReader(path).read(); });
}

}  // namespace idiophone::harmonic

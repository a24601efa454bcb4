#include "recording_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "surface_motion_paths.hpp"

namespace idiophone::results {

namespace {

double number_or(hid_t file, const std::string& name, double otherwise) {
  return hdf5::has(file, name) ? hdf5::number_of(file, name) : otherwise;
}

Origin read_origin(hid_t file, const std::filesystem::path& path) {
  Origin origin{.name = path.stem().string(), .code_version = "", .deck_text = "", .overrides = {}};
  for (const auto& [name, text] : {std::pair("name", &origin.name), std::pair("code_version", &origin.code_version)}) {
    if (hdf5::has(file, name)) {
      *text = hdf5::text_of(file, name);
    }
  }
  if (has_dataset(file, "/deck")) {
    origin.deck_text = hdf5::text_in(file, "/deck");
    origin.overrides = hdf5::texts_in(file, "/overrides");
  }
  return origin;
}

std::vector<surface::BodyOffsets> read_bodies(hid_t file, const std::filesystem::path& path) {
  if (!has_dataset(file, surface_motion::body_names)) {
    return {{.name = "body"}};
  }
  const auto numbers = [&](const std::string& name) {
    const auto dataset = hdf5::open_dataset(file, name);
    return hdf5::read<std::int32_t>(dataset.id(), hdf5::whole(dataset.id()));
  };
  const auto names = hdf5::texts_in(file, surface_motion::body_names);
  const auto triangles = numbers(surface_motion::first_triangles);
  const auto vertices = numbers(surface_motion::first_vertices);
  require(triangles.size() == names.size() && vertices.size() == names.size(), path, "/bodies contradicts itself");
  std::vector<surface::BodyOffsets> bodies;
  for (std::size_t b = 0; b < names.size(); ++b) {
    bodies.push_back({names[b], triangles[b], vertices[b]});
  }
  return bodies;
}

/// @param width  numbers in a row
std::vector<double> read_obstacles(hid_t file, const std::string& name, std::size_t width,
                                   const std::filesystem::path& path) {
  if (!has_dataset(file, name)) {
    return {};
  }
  const auto dataset = hdf5::open_dataset(file, name);
  auto numbers = hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()));
  require(numbers.size() % width == 0, path, fmt::format("{} does not hold {} numbers for each", name, width));
  return numbers;
}

}  // namespace

void require(bool condition, const std::filesystem::path& path, const std::string& problem) {
  if (!condition) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), problem));
  }
}

bool has_dataset(hid_t file, const std::string& path) {
  const auto paths = hdf5::datasets_below(file, "/");
  return std::ranges::find(paths, path) != paths.end();
}

double read_recording_rate(hid_t file, const std::filesystem::path& path) {
  require(hdf5::has(file, "rate"), path, "the attribute rate (Hz) is missing");
  const double rate = hdf5::number_of(file, "rate");
  require(rate >= 2000.0 && rate <= 1e6 && rate == std::floor(rate), path,
          fmt::format("the rate has to be a whole number from 2000 to 1000000 Hz, not {}", rate));
  return rate;
}

surface::RecordingHeader read_recording_header(hid_t file, const std::filesystem::path& path,
                                               const RecordingSize& size) {
  surface::RecordingHeader header;
  header.rate = read_recording_rate(file, path);
  header.origin = read_origin(file, path);
  header.first_sample = hdf5::has(file, "first_sample") ? hdf5::integer_of(file, "first_sample") : 0;
  require(header.first_sample <= 0 && header.first_sample > -1000000, path,
          fmt::format("first_sample has to be at most 0 and above -1000000, not {}", header.first_sample));
  header.samples = hdf5::has(file, "samples") ? hdf5::integer_of(file, "samples") : size.rows - 1 + header.first_sample;
  header.air_density = number_or(file, "air_density", 1.21);
  header.air_speed = number_or(file, "air_speed", 343.0);
  require(header.air_density > 0 && std::isfinite(header.air_density) && header.air_speed > 0 &&
              std::isfinite(header.air_speed),
          path, "air_density (kg/m3) and air_speed (m/s) have to be above 0");
  header.bodies = read_bodies(file, path);
  header.obstacle_triangles = read_obstacles(file, surface_motion::obstacle_triangles, 9, path);
  header.half_spaces = read_obstacles(file, surface_motion::half_spaces, 6, path);
  for (std::size_t b = 0; b < header.bodies.size(); ++b) {
    const surface::BodyOffsets zero{};
    const surface::BodyOffsets& before = b == 0 ? zero : header.bodies[b - 1];
    const surface::BodyOffsets& body = header.bodies[b];
    require(body.first_triangle >= before.first_triangle && body.first_triangle < size.triangles &&
                body.first_vertex >= before.first_vertex && body.first_vertex < size.vertices,
            path, fmt::format("/bodies: '{}' begins outside of the surface", body.name));
  }
  return header;
}

}  // namespace idiophone::results

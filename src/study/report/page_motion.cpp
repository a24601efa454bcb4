#include "page_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/web/web_page.hpp"
#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "outer_surface.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

constexpr std::int64_t most_rows = 1500;
constexpr std::size_t most_coordinates = 3'000'000;  // of all frames: 8 MB of the page

json thinned(const results::SeriesReader& reader, const spectra::Series& series) {
  const std::size_t width = series.columns.size();
  const std::vector<double> values = reader.read(series);
  const auto rows = static_cast<std::int64_t>(values.size() / width);
  const std::int64_t stride = std::max<std::int64_t>(1, rows / most_rows);
  std::vector<float> times;
  std::vector<float> kept;
  for (std::int64_t begin = 0; begin < rows; begin += stride) {
    std::int64_t largest = begin;
    double most = -1.0;
    for (std::int64_t row = begin; row < std::min(begin + stride, rows); ++row) {
      for (const double value : std::span(values).subspan(row * width, width)) {
        if (std::abs(value) > most) {
          most = std::abs(value);
          largest = row;
        }
      }
    }
    times.push_back(static_cast<float>(static_cast<double>(largest) / series.rate));
    for (const double value : std::span(values).subspan(largest * width, width)) {
      kept.push_back(static_cast<float>(value));
    }
  }
  return {{"path", series.path},
          {"unit", series.unit},
          {"columns", series.columns},
          {"times", web::encoded(times)},
          {"values", web::encoded(kept)}};
}

/// A body's surface with vertices of its own.
struct Surface {
  std::vector<std::int32_t> nodes;  ///< [vertices]
  std::vector<std::uint32_t> triangles;
};

Surface compact(const std::vector<Triangle>& triangles) {
  Surface surface;
  std::map<std::int32_t, std::uint32_t> places;
  for (const Triangle& triangle : triangles) {
    for (const std::int32_t node : triangle) {
      const auto [place, is_new] = places.try_emplace(node, static_cast<std::uint32_t>(surface.nodes.size()));
      if (is_new) {
        surface.nodes.push_back(node);
      }
      surface.triangles.push_back(place->second);
    }
  }
  return surface;
}

json body_frames(const results::FrameReader& reader, std::size_t number, const Surface& surface,
                 const std::vector<std::size_t>& chosen) {
  const results::FramedBody& body = reader.bodies()[number];
  std::vector<float> vertices;
  for (const std::int32_t node : surface.nodes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertices.push_back(static_cast<float>(body.nodes[3 * static_cast<std::size_t>(node) + axis]));
    }
  }
  std::vector<float> displacement;
  for (const std::size_t frame : chosen) {
    const std::vector<float> all = reader.displacement(number, frame);
    for (const std::int32_t node : surface.nodes) {
      displacement.insert(displacement.end(), &all[3 * static_cast<std::size_t>(node)],
                          &all[3 * static_cast<std::size_t>(node)] + 3);
    }
  }
  float largest = 0.0F;
  for (const float value : displacement) {
    largest = std::max(largest, std::abs(value));
  }
  const float scale = largest > 0.0F ? largest / 32767.0F : 1.0F;
  std::vector<std::int16_t> whole;
  std::ranges::transform(displacement, std::back_inserter(whole),
                         [scale](float value) { return static_cast<std::int16_t>(std::lround(value / scale)); });
  return {{"name", body.name},
          {"vertices", web::encoded(vertices)},
          {"triangles", web::encoded(surface.triangles)},
          {"displacement", web::encoded(whole)},
          {"scale", scale}};
}

}  // namespace

json channels_over_time(const std::filesystem::path& result) {
  const results::SeriesReader reader(result);
  json all = json::array();
  for (const spectra::Series& series : reader.all()) {
    if (series.path == "/energy" || (series.path.starts_with("/contacts/") && series.path.ends_with("/force"))) {
      all.push_back(thinned(reader, series));
    }
  }
  return all;
}

json frames(const std::filesystem::path& result) {
  const results::FrameReader reader(result);
  std::vector<Surface> surfaces;
  std::size_t coordinates = 0;
  for (const results::FramedBody& body : reader.bodies()) {
    surfaces.push_back(compact(surface_of(body)));
    coordinates += 3 * surfaces.back().nodes.size();
  }
  const std::size_t count = reader.times().size();
  if (count == 0 || coordinates == 0) {
    return {};
  }
  const std::size_t most = std::max<std::size_t>(1, most_coordinates / coordinates);
  const std::size_t stride = (count + most - 1) / most;
  json answer = {{"times", json::array()}, {"bodies", json::array()}};
  std::vector<std::size_t> chosen;
  for (std::size_t frame = 0; frame < count; frame += stride) {
    chosen.push_back(frame);
    answer["times"].push_back(reader.times()[frame]);
  }
  for (std::size_t body = 0; body < surfaces.size(); ++body) {
    answer["bodies"].push_back(body_frames(reader, body, surfaces[body], chosen));
  }
  return answer;
}

}  // namespace idiophone::report

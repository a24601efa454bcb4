#include "idiophone/study/contents/describe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/foundation/element/deck_keys.hpp"
#include "idiophone/foundation/listed_names.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/checkpoint_format.hpp"
#include "idiophone/run/results/describe_file.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"

namespace idiophone::contents {

namespace {

std::string one_line(const std::string& path, const hdf5::Dimensions& shape, const std::string& remark) {
  return fmt::format("  {:<36} [{}]{}\n", path, fmt::join(shape, " x "), remark);
}

std::string series_line(const results::SeriesReader& reader, const spectra::Series& series) {
  const std::int64_t rows = reader.rows(series);
  return one_line(series.path, {static_cast<hsize_t>(rows), series.columns.size()},
                  fmt::format(" {}, {} Hz, {:.6g} s, loudest {:.6g}: {}", series.unit, series.rate,
                              static_cast<double>(rows) / series.rate, results::loudest(reader, series),
                              fmt::join(series.columns, " ")));
}

std::string dataset_line(const std::string& path, hid_t dataset) {
  std::string remark;
  for (const auto* const attribute : {"name", "unit"}) {
    remark += hdf5::has(dataset, attribute) ? fmt::format(" {}", hdf5::text_of(dataset, attribute)) : "";
  }
  return one_line(path, hdf5::shape_of(dataset), remark);
}

/// By path.
std::map<std::string, std::string> dataset_lines(hid_t file, const std::filesystem::path& path) {
  std::map<std::string, std::string> lines;
  if (files::format_of(file) == files::result_format) {
    const results::SeriesReader reader(path);
    for (const spectra::Series& series : reader.all()) {
      lines[series.path] = series_line(reader, series);
    }
  }
  for (const auto& name : hdf5::datasets_below(file, "/")) {
    if (!lines.contains(name) && !name.starts_with(files::checksums_group)) {
      lines[name] = dataset_line(name, hdf5::open_dataset(file, name).id());
    }
  }
  return lines;
}

std::string describe_result(hid_t file, const std::filesystem::path& path) {
  return fmt::format("{}: result of the run '{}', written by idiophone {} (format version {})\n", path.string(),
                     hdf5::text_of(file, "name"), hdf5::text_of(file, "code_version"),
                     hdf5::integer_of(file, "format_version"));
}

std::string describe_recording(const std::filesystem::path& path) {
  const results::SurfaceMotionReader recording(path);
  const surface::RecordingHeader& header = recording.header();
  std::vector<std::string> names;
  std::ranges::transform(header.bodies, std::back_inserter(names), &surface::BodyOffsets::name);
  return fmt::format(
      "{}: surface motion of the run '{}', written by idiophone {} (format version {})\n"
      "  {} audio samples at {} Hz, the first {}: {:.6g} s; {} triangles and {} vertices of {}; air of {:.6g} kg/m3 "
      "and {:.6g} m/s\n",
      path.string(), header.origin.name, header.origin.code_version, files::version_of(files::surface_motion_format),
      recording.rows(), header.rate, header.first_sample, static_cast<double>(recording.rows()) / header.rate,
      recording.triangles(), recording.vertices(), fmt::join(names, ", "), header.air_density, header.air_speed);
}

std::string describe_sound_map(const std::filesystem::path& path) {
  const sound_maps::SoundMap map = sound_maps::read_sound_map(path);
  const std::string errors = sound_maps::mesh_error_text(map);
  return fmt::format(
      "{}: sound map of the {} '{}' of the deck '{}', written by idiophone {} (format version {})\n"
      "  {} modes from {:.6g} to {:.6g} Hz; {} vertices, {} triangles, {:.6g} kg; {} listeners, {} directions (model "
      "{})\n{}{}",
      path.string(), map.kind, map.body, map.name, map.code_version, files::version_of(files::sound_map_format),
      map.modes(), map.frequency.front(), map.frequency.back(), map.vertices.size(), map.triangles.size(), map.mass,
      map.listeners.size(), map.sphere.direction.size(), map.radiation,
      map.stretching.exists() ? fmt::format("  large amplitudes: {} terms of stretching\n", map.stretching.terms())
                              : "",
      errors.empty() ? "" : fmt::format("  {}\n", errors));
}

std::string describe_radiation(hid_t file, const std::filesystem::path& path) {
  const auto dataset = hdf5::open_dataset(file, "/sounds/frequency");
  const auto frequencies = hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()));
  const auto rows = [file](const char* table) { return hdf5::row_count(hdf5::open_dataset(file, table).id()); };
  if (frequencies.empty()) {
    throw std::runtime_error("/sounds/frequency is empty");
  }
  const auto [lowest, highest] = std::minmax_element(frequencies.begin(), frequencies.end());
  return fmt::format(
      "{}: sound that the body '{}' of the deck '{}' radiates, written by idiophone {} (format version {})\n"
      "  {} sounds from {:.6g} to {:.6g} Hz; {} vertices, {} triangles of {}; {} directions\n",
      path.string(), hdf5::text_of(file, "body"), hdf5::text_of(file, "name"), hdf5::text_of(file, "code_version"),
      files::version_of(files::radiation_format), frequencies.size(), *lowest, *highest, rows("/surface/vertices"),
      rows("/surface/triangles"), fmt::join(hdf5::texts_in(file, "/surface/parts"), ", "), rows("/sphere/direction"));
}

std::string describe_mesh(hid_t file, const std::filesystem::path& path) {
  const mesh::StoredMesh stored = mesh::read_mesh_file(path);
  return fmt::format(
      "{}: mesh of the body '{}' of the deck '{}', written by idiophone {} (format version {}), mesh {}\n"
      "  {} nodes, {} elements, {} surface triangles\n  {}\n  groups: {}\n  groups of elements: {}\n",
      path.string(), stored.body, hdf5::text_of(file, "name"), hdf5::text_of(file, "code_version"),
      files::version_of(files::mesh_format), stored.mesh.hash, stored.mesh.nodes.size(), stored.mesh.element_count(),
      stored.mesh.surface.size(), element::deck_keys(stored.mesh.element), listed_names(stored.mesh.groups),
      listed_names(stored.element_groups));
}

std::string describe_checkpoint(hid_t file, const std::filesystem::path& path) {
  const auto moment = results::read_moment(file);
  auto text =
      fmt::format("{}: checkpoint at step {}, sample {}, written by idiophone {} (format version {}), mesh {}\n",
                  path.string(), moment.step, moment.sample, hdf5::text_of(file, "code_version"),
                  hdf5::integer_of(file, "format_version"), hdf5::text_of(file, "mesh_hash"));
  const auto reason = results::damage(path);
  return text + (reason.empty() ? "  valid: all checksums are right\n" : fmt::format("  NOT VALID: {}\n", reason));
}

std::string describe_job(std::size_t number, const nlohmann::json& job) {
  auto text = fmt::format("  job {}: {} rank{}, {}, from audio sample {}", number, job.at("ranks").dump(),
                          job.at("ranks") == 1 ? "" : "s", job.at("instruction_set").get<std::string>(),
                          job.at("first_sample").dump());
  if (!job.contains("last_sample")) {
    return text + "; it did not stop in good order\n";
  }
  text += fmt::format(" to {}, {:.1f} s of computing", job.at("last_sample").dump(), job.at("elapsed").get<double>());
  if (job.contains("elements_per_second")) {
    text += fmt::format(", {:.4g} million elements a second and core",
                        job.at("elements_per_second").get<double>() / job.at("ranks").get<double>() / 1e6);
  }
  text += "\n    share of time on rank 0:";
  double total = 0.0;
  for (const auto& [stage, seconds] : job.at("stages").items()) {
    total += seconds.get<double>();
  }
  for (const auto& [stage, seconds] : job.at("stages").items()) {
    text += fmt::format("  {} {:.1f} %", stage, 100 * seconds.get<double>() / total);
  }
  return text + "\n";
}

/// Lines about /run; empty if the file has no /run.
/// @throws nlohmann::json::exception if facts are missing or of another type
std::string lines_about_run(const nlohmann::json& run) {
  std::string text;
  if (run.contains("step")) {
    text +=
        fmt::format("  step {:.6g} s: {} steps per audio sample, surface read every {}\n", run.at("step").get<double>(),
                    run.at("steps_per_sample").dump(), run.at("steps_per_read").dump());
    for (const auto& [name, body] : run.at("bodies").items()) {
      text += fmt::format("  body {}: {} nodes, {} {} elements, {} surface triangles, {:.6g} kg\n", name,
                          body.at("nodes").dump(), body.at("elements").dump(), body.at("element").get<std::string>(),
                          body.at("triangles").dump(), body.at("mass").get<double>());
    }
  }
  std::size_t number = 0;
  for (const auto& job : run.value("jobs", nlohmann::json::array())) {
    text += describe_job(++number, job);
  }
  return text;
}

std::string describe_run(hid_t file) {
  try {
    return lines_about_run(results::run_facts(file));
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error("/run lacks facts, or has them as values of another type");
  }
}

}  // namespace

namespace {

std::string description_of(const std::filesystem::path& path) {
  const auto file = results::open_described(path);
  const auto format = files::format_of(file.id());
  auto text = format == files::result_format           ? describe_result(file.id(), path)
              : format == files::surface_motion_format ? describe_recording(path)
              : format == files::sound_map_format      ? describe_sound_map(path)
              : format == files::radiation_format      ? describe_radiation(file.id(), path)
              : format == files::mesh_format           ? describe_mesh(file.id(), path)
                                                       : describe_checkpoint(file.id(), path);
  text += describe_run(file.id());
  for (const auto& [name, line] : dataset_lines(file.id(), path)) {
    text += line;
  }
  return text;
}

}  // namespace

std::string describe(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return description_of(path); });
}

}  // namespace idiophone::contents

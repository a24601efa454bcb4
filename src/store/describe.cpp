#include "idiophone/store/describe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "attributes.hpp"
#include "checkpoint_format.hpp"
#include "format.hpp"
#include "idiophone/store/surface_motion_reader.hpp"

namespace idiophone::store {

namespace {

std::string one_line(const std::string& path, hid_t dataset, const std::string& remark) {
  return fmt::format("  {:<36} [{}]{}\n", path, fmt::join(hdf5::shape_of(dataset), " x "), remark);
}

/// The value of largest magnitude, read by pieces so that long results need little memory.
double loudest(hid_t table) {
  const auto shape = hdf5::shape_of(table);
  const hsize_t rows_at_once = std::max<hsize_t>((1U << 20U) / std::max<hsize_t>(shape[1], 1), 1);
  double extreme = 0.0;
  for (hsize_t row = 0; row < shape[0]; row += rows_at_once) {
    const auto values = hdf5::read<double>(table, {{row, 0}, {std::min(rows_at_once, shape[0] - row), shape[1]}});
    for (const auto value : values) {
      extreme = std::abs(value) > std::abs(extreme) || std::isnan(value) ? value : extreme;
    }
  }
  return extreme;
}

std::string series_line(const std::string& path, hid_t table) {
  const auto unit = hdf5::text_of(table, "unit");
  const auto rate = hdf5::number_of(table, "rate");
  const auto duration = static_cast<double>(hdf5::shape_of(table).at(0)) / rate;
  return one_line(path, table,
                  fmt::format(" {}, {} Hz, {:.6g} s, loudest {:.6g}: {}", unit, rate, duration, loudest(table),
                              fmt::join(hdf5::texts_of(table, "columns"), " ")));
}

std::string dataset_line(hid_t file, const std::string& path) {
  const auto dataset = hdf5::open_dataset(file, path);
  if (hdf5::has(dataset.id(), "rate")) {
    return series_line(path, dataset.id());
  }
  std::string remark;
  for (const auto* const attribute : {"name", "unit"}) {
    remark += hdf5::has(dataset.id(), attribute) ? fmt::format(" {}", hdf5::text_of(dataset.id(), attribute)) : "";
  }
  return one_line(path, dataset.id(), remark);
}

/// What is wrong with a checkpoint; empty for nothing.
std::string damage(const std::filesystem::path& path) {
  try {
    const CheckpointReader reader(path, MPI_COMM_SELF);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string describe_result(hid_t file, const std::filesystem::path& path) {
  return fmt::format("{}: result of the run '{}', written by idiophone {} (format version {})\n", path.string(),
                     hdf5::text_of(file, "name"), hdf5::text_of(file, "code_version"),
                     hdf5::integer_of(file, "format_version"));
}

std::string describe_recording(const std::filesystem::path& path) {
  const SurfaceMotionReader recording(path);
  const RecordingHeader& header = recording.header();
  std::vector<std::string> names;
  std::ranges::transform(header.bodies, std::back_inserter(names), &RecordedBody::name);
  return fmt::format(
      "{}: surface motion of the run '{}', written by idiophone {} (format version {})\n"
      "  {} audio samples at {} Hz, the first {}: {:.6g} s; {} triangles and {} vertices of {}; air of {:.6g} kg/m3 "
      "and "
      "{:.6g} m/s\n",
      path.string(), header.origin.name, header.origin.code_version, version_of(surface_motion_format), recording.rows(), header.rate,
      header.first_sample, static_cast<double>(recording.rows()) / header.rate, recording.triangles(),
      recording.vertices(), fmt::join(names, ", "), header.air_density, header.air_speed);
}

std::string describe_checkpoint(hid_t file, const std::filesystem::path& path) {
  const auto moment = read_moment(file);
  auto text =
      fmt::format("{}: checkpoint at step {}, sample {}, written by idiophone {} (format version {}), mesh {}\n",
                  path.string(), moment.step, moment.sample, hdf5::text_of(file, "code_version"),
                  hdf5::integer_of(file, "format_version"), hdf5::text_of(file, "mesh_hash"));
  const auto reason = damage(path);
  return text + (reason.empty() ? "  valid: all checksums are right\n" : fmt::format("  NOT VALID: {}\n", reason));
}

}  // namespace

std::string describe(const std::filesystem::path& path) {
  const auto file = hdf5::open_for_reading(path);
  const auto format = format_of(file.id());
  if (format != result_format && format != checkpoint_format && format != surface_motion_format) {
    throw std::runtime_error(fmt::format("{} is no result, recording or checkpoint of idiophone", path.string()));
  }
  check_format(file.id(), format, path);
  auto text = format == result_format           ? describe_result(file.id(), path)
              : format == surface_motion_format ? describe_recording(path)
                                                : describe_checkpoint(file.id(), path);
  for (const auto& dataset : hdf5::datasets_below(file.id(), "/")) {
    text += dataset_line(file.id(), dataset);
  }
  return text;
}

}  // namespace idiophone::store

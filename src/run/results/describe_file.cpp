#include "idiophone/run/results/describe_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/run/results/checkpoint.hpp"

namespace idiophone::results {

namespace {

/// Numbers of an attribute, one or many, of one kind.
template <class T>
nlohmann::json numbers(hid_t attribute, const hdf5::Identifier& space) {
  const auto dimensions = hdf5::shape_of_space(space.id());
  std::vector<T> values(hdf5::volume(dimensions));
  hdf5::check(H5Aread(attribute, hdf5::type_of<T>(), values.data()), "can't read an attribute");
  if (dimensions.empty()) {
    return values.front();
  }
  if (dimensions.size() == 1) {
    return values;
  }
  auto rows = nlohmann::json::array();
  const auto width = static_cast<std::ptrdiff_t>(values.size() / std::max<hsize_t>(dimensions[0], 1));
  for (auto row = values.begin(); row != values.end(); row += width) {
    rows.push_back(std::vector<T>(row, row + width));
  }
  return rows;
}

nlohmann::json attribute(hid_t object, const std::string& name) {
  const hdf5::Identifier opened(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, name);
  const hdf5::Identifier type(H5Aget_type(opened.id()), H5Tclose, name);
  const auto space = hdf5::space_of_attribute(opened.id(), name);
  switch (H5Tget_class(type.id())) {
    case H5T_STRING:
      return H5Sget_simple_extent_ndims(space.id()) == 0 ? nlohmann::json(hdf5::text_of(object, name))
                                                         : nlohmann::json(hdf5::texts_of(object, name));
    case H5T_INTEGER:
      return numbers<std::int64_t>(opened.id(), space);
    default:
      return numbers<double>(opened.id(), space);
  }
}

}  // namespace

nlohmann::json attributes(hid_t object) {
  auto found = nlohmann::json::object();
  for (const std::string& name : hdf5::attribute_names(object)) {
    found[name] = attribute(object, name);
  }
  return found;
}

namespace {

/// A group of facts, as result_facts.cpp writes them.
nlohmann::json facts(hid_t file, const std::string& path) {
  const hdf5::Identifier group(H5Gopen2(file, path.c_str(), H5P_DEFAULT), H5Gclose, "can't open group " + path);
  auto found = attributes(group.id());
  for (const auto& [name, is_group] : hdf5::entries_of(group.id())) {
    const std::string below = fmt::format("{}/{}", path, name);
    found[name] = is_group ? facts(file, below) : nlohmann::json(hdf5::text_in(file, below));
  }
  return found;
}

}  // namespace

nlohmann::json run_facts(hid_t file) {
  if (!hdf5::exists(file, "/run")) {
    return nlohmann::json::object();
  }
  auto run = facts(file, "/run");
  auto jobs = nlohmann::json::array();
  for (const auto& job : run.value("jobs", nlohmann::json::object())) {
    jobs.push_back(job);
  }
  run["jobs"] = jobs;
  return run;
}

// By pieces, so that long results need little memory.
double loudest(const SeriesReader& reader, const spectra::Series& series) {
  constexpr std::int64_t values_at_once = 1 << 20;
  const auto rows_at_once = std::max<std::int64_t>(values_at_once / std::ssize(series.columns), 1);
  const std::int64_t rows = reader.rows(series);
  double extreme = 0.0;
  for (std::int64_t row = 0; row < rows; row += rows_at_once) {
    for (const double value : reader.read(series, row, std::min(rows_at_once, rows - row))) {
      extreme = std::abs(value) > std::abs(extreme) || std::isnan(value) ? value : extreme;
    }
  }
  return extreme;
}

std::string damage(const std::filesystem::path& path) {
  try {
    const CheckpointReader reader(path, MPI_COMM_SELF);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

hdf5::Identifier open_described(const std::filesystem::path& path) {
  auto file = hdf5::open_for_reading(path);
  const auto format = files::format_of(file.id());
  if (format != files::result_format && format != files::checkpoint_format && format != files::surface_motion_format &&
      format != files::sound_map_format && format != files::radiation_format && format != files::mesh_format) {
    throw std::runtime_error(fmt::format(
        "{} is no result, recording, checkpoint, sound map, radiated sound or mesh of idiophone", path.string()));
  }
  files::check_format(file.id(), format, path);
  return file;
}

}  // namespace idiophone::results

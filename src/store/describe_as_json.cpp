// Contents of a file as JSON.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "attributes.hpp"
#include "describe_file.hpp"
#include "format.hpp"
#include "hdf5_dataset.hpp"
#include "hdf5_group.hpp"
#include "idiophone/store/describe.hpp"
#include "reading.hpp"
#include "table_checksums.hpp"

namespace idiophone::store {

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

nlohmann::json attributes(hid_t object) {
  auto found = nlohmann::json::object();
  for (const std::string& name : hdf5::attribute_names(object)) {
    found[name] = attribute(object, name);
  }
  return found;
}

bool is_text(hid_t dataset) {
  const hdf5::Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  return H5Tget_class(type.id()) == H5T_STRING;
}

nlohmann::json dataset(hid_t file, const std::string& path) {
  const auto opened = hdf5::open_dataset(file, path);
  auto found = attributes(opened.id());
  found["shape"] = hdf5::shape_of(opened.id());
  if (is_text(opened.id())) {
    found["text"] = hdf5::texts_in(file, path);
  }
  return found;
}

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

namespace {

std::string json_of(const std::filesystem::path& path) {
  const auto file = open_described(path);
  auto all = attributes(file.id());
  all["file"] = path.string();
  if (const auto run = run_facts(file.id()); !run.empty()) {
    all["run"] = run;
  }
  if (format_of(file.id()) == checkpoint_format) {
    const std::string reason = damage(path);
    all["valid"] = reason.empty();
    all["damage"] = reason;
  }
  for (const auto& each : hdf5::datasets_below(file.id(), "/")) {
    if (!each.starts_with("/run/") && !each.starts_with(checksums_group)) {
      all["datasets"][each] = dataset(file.id(), each);
    }
  }
  if (format_of(file.id()) == result_format) {
    const SeriesReader reader(path);
    for (const Series& series : reader.all()) {
      all["datasets"][series.path]["loudest"] = loudest(reader, series);
    }
  }
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string describe_as_json(const std::filesystem::path& path) {
  return read_within_limit(path, [&] { return json_of(path); });
}

}  // namespace idiophone::store

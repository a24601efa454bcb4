// Contents of a file as JSON.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/run/results/describe_file.hpp"
#include "idiophone/study/contents/describe.hpp"

namespace idiophone::contents {

namespace {

bool is_text(hid_t dataset) {
  const hdf5::Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  return H5Tget_class(type.id()) == H5T_STRING;
}

nlohmann::json dataset(hid_t file, const std::string& path) {
  const auto opened = hdf5::open_dataset(file, path);
  auto found = results::attributes(opened.id());
  found["shape"] = hdf5::shape_of(opened.id());
  if (is_text(opened.id())) {
    found["text"] = hdf5::texts_in(file, path);
  }
  return found;
}

std::string json_of(const std::filesystem::path& path) {
  const auto file = results::open_described(path);
  auto all = results::attributes(file.id());
  all["file"] = path.string();
  if (const auto run = results::run_facts(file.id()); !run.empty()) {
    all["run"] = run;
  }
  if (files::format_of(file.id()) == files::checkpoint_format) {
    const std::string reason = results::damage(path);
    all["valid"] = reason.empty();
    all["damage"] = reason;
  }
  for (const auto& each : hdf5::datasets_below(file.id(), "/")) {
    if (!each.starts_with("/run/") && !each.starts_with(files::checksums_group)) {
      all["datasets"][each] = dataset(file.id(), each);
    }
  }
  if (files::format_of(file.id()) == files::result_format) {
    const results::SeriesReader reader(path);
    for (const spectra::Series& series : reader.all()) {
      all["datasets"][series.path]["loudest"] = results::loudest(reader, series);
    }
  }
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string describe_as_json(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return json_of(path); });
}

}  // namespace idiophone::contents

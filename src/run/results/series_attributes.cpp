#include "series_attributes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/hdf5_dataset.hpp"

namespace idiophone::results {

bool is_series(hid_t dataset) {
  return hdf5::has(dataset, "rate");
}

void put_series(hid_t dataset, const spectra::Series& series) {
  hdf5::put(dataset, "unit", series.unit);
  hdf5::put(dataset, "rate", series.rate);
  hdf5::put(dataset, "columns", series.columns);
  hdf5::put(dataset, "description", series.description);
  if (!series.positions.empty()) {
    hdf5::put(dataset, "positions", series.positions);
  }
  if (!series.attached.empty()) {
    hdf5::put(dataset, "attached", series.attached);
  }
}

spectra::Series get_series(hid_t dataset, const std::string& path) {
  spectra::Series series{.path = path,
                         .unit = hdf5::text_of(dataset, "unit"),
                         .rate = hdf5::number_of(dataset, "rate"),
                         .columns = hdf5::texts_of(dataset, "columns"),
                         .description = hdf5::text_of(dataset, "description"),
                         .positions = {}};
  const hdf5::Dimensions shape = hdf5::shape_of(dataset);
  if (shape.size() != 2 || shape[1] != series.columns.size() || series.columns.empty()) {
    throw std::runtime_error(
        fmt::format("{} has names for {} columns, but another shape", path, series.columns.size()));
  }
  if (!(series.rate > 0.0) || !std::isfinite(series.rate)) {
    throw std::runtime_error(fmt::format("{} has a rate of {} Hz", path, series.rate));
  }
  if (hdf5::has(dataset, "positions")) {
    series.positions = hdf5::points_of(dataset, "positions");
  }
  if (hdf5::has(dataset, "attached")) {
    series.attached = hdf5::text_of(dataset, "attached");
  }
  return series;
}

}  // namespace idiophone::results

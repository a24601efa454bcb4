#pragma once
// The attributes of a series' dataset.

#include <string>

#include "idiophone/files/hdf5.hpp"
#include "idiophone/foundation/spectra/series.hpp"

namespace idiophone::results {

/// Whether a dataset is a series.
[[nodiscard]] bool is_series(hid_t dataset);

/// Writes all but the path to a new dataset. In a file that is open on all ranks, collective.
void put_series(hid_t dataset, const spectra::Series& series);

/// @throws std::runtime_error if the dataset is not a series, or damaged
[[nodiscard]] spectra::Series get_series(hid_t dataset, const std::string& path);

}  // namespace idiophone::results

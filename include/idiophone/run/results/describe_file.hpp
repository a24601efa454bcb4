#pragma once
// What is in a file of any of our formats, for its description and its verification.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "idiophone/files/hdf5.hpp"
#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::results {

/// Opens a result, a recording, a checkpoint, a sound map or a file of radiated sound.
/// @throws std::runtime_error if it is none of them
[[nodiscard]] hdf5::Identifier open_described(const std::filesystem::path& path);

/// The value of largest magnitude in a series.
[[nodiscard]] double loudest(const SeriesReader& reader, const spectra::Series& series);

/// What is wrong with a checkpoint; empty if it is valid.
[[nodiscard]] std::string damage(const std::filesystem::path& path);

/// The attributes of a group or dataset, by name.
[[nodiscard]] nlohmann::json attributes(hid_t object);

/// The contents of /run, with the jobs as a list. Empty if the file has no /run.
[[nodiscard]] nlohmann::json run_facts(hid_t file);

}  // namespace idiophone::results

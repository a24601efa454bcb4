#pragma once
// What both descriptions of a file need: text (describe.cpp) and JSON (describe_as_json.cpp).

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hdf5.hpp"
#include "idiophone/store/series_reader.hpp"

namespace idiophone::store {

/// Opens a result, a recording, a checkpoint or a sound map.
/// @throws std::runtime_error if it is none of them
[[nodiscard]] hdf5::Identifier open_described(const std::filesystem::path& path);

/// The value of largest magnitude in a series.
[[nodiscard]] double loudest(const SeriesReader& reader, const Series& series);

/// What is wrong with a checkpoint; empty for nothing.
[[nodiscard]] std::string damage(const std::filesystem::path& path);

/// What /run says; its jobs are a list. Empty where the file has no /run.
[[nodiscard]] nlohmann::json run_facts(hid_t file);

}  // namespace idiophone::store

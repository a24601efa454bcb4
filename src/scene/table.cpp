// Tables in CSV files: rows of a time and what belongs to it. Tables of a time and a value can also be sound files.

#include <cmath>
#include <optional>
#include <utility>

#include "idiophone/foundation/deck/csv.hpp"
#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/scene/sections.hpp"
#include "table_header.hpp"

namespace idiophone::scene {

namespace {

/// Reports the first time that is not at least 0, and the first one that does not follow the one before.
bool check_times(const std::vector<deck::CsvRow>& rows, Mistakes& mistakes) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double time = rows[i].values[0];
    if (time < 0.0) {
      mistakes.add(rows[i].where, fmt::format("the time must be at least 0 s, found {}", time));
      return false;
    }
    if (i > 0 && time <= rows[i - 1].values[0]) {
      mistakes.add(rows[i].where,
                   fmt::format("times must ascend; {} s does not follow {} s", time, rows[i - 1].values[0]));
      return false;
    }
  }
  return true;
}

/// What a table may begin with.
enum class TableHead { rows, units };

/// The rows of a file, a time (s) first; times and the first values are in SI units if a header names other ones.
bool read_rows(const std::filesystem::path& file, const CsvColumns& columns, TableHead head, Mistakes& mistakes,
               std::vector<deck::CsvRow>& rows) {
  std::vector<deck::CsvColumn> described;
  for (const std::string& name : columns.names) {
    described.push_back({.name = name, .unit = described.empty() ? "s" : ""});
  }
  std::optional<deck::CsvHeader> header;
  if (!deck::read_csv(file, described, mistakes, rows, head == TableHead::units ? &header : nullptr)) {
    return false;
  }
  const auto units = header ? read_table_header(header->text, header->where, mistakes) : TableUnits{};
  if (!units) {
    return false;
  }
  for (deck::CsvRow& row : rows) {
    row.values[0] *= units->time;
    row.values[1] *= units->value;
  }
  return check_times(rows, mistakes);
}

bool read_table(const Node& node, Mistakes& mistakes, CsvRows& rows, const std::filesystem::path& file,
                const CsvColumns& columns, TableHead head) {
  std::vector<deck::CsvRow> found;
  if (!read_rows(file, columns, head, mistakes, found)) {
    return false;
  }
  for (deck::CsvRow& row : found) {
    rows.push_back(std::move(row.values));
  }
  if (rows.size() >= 2) {
    return true;
  }
  return mistakes.add(node, fmt::format("needs at least 2 rows '{}', found {} in {}", fmt::join(columns.names, ", "),
                                        rows.size(), std::filesystem::absolute(file).string()));
}

/// The samples of a recording, 1 at full scale.
bool read_recording(const Node& node, Mistakes& mistakes, Table& table, const std::filesystem::path& file) {
  try {
    const spectra::SoundFile sound = spectra::read_sound_file(file);
    if (sound.channels.size() != 1 || sound.channels.front().size() < 2) {
      return mistakes.add(node, fmt::format("must have one channel of at least 2 samples; {} has {} channels of {}",
                                            std::filesystem::absolute(file).string(), sound.channels.size(),
                                            sound.channels.empty() ? 0 : sound.channels.front().size()));
    }
    for (const double sample : sound.channels.front()) {
      if (!std::isfinite(sample)) {
        return mistakes.add(node, fmt::format("{} has a sample that is not finite, number {}",
                                              std::filesystem::absolute(file).string(), table.size()));
      }
      table.push_back({static_cast<double>(table.size()) / sound.rate, sample});
    }
    return true;
  } catch (const std::runtime_error& error) {
    return mistakes.add(node, error.what());
  }
}

bool is_recording(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".wav" || ending == ".flac" || ending == ".aiff" || ending == ".ogg";
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, CsvRows& rows, const Folder& folder, const CsvColumns& columns) {
  std::filesystem::path file;
  return read(node, mistakes, file, folder) && read_table(node, mistakes, rows, file, columns, TableHead::rows);
}

bool read(const Node& node, Mistakes& mistakes, Table& table, const Folder& folder, const TimeAndValue& /*rule*/) {
  std::filesystem::path file;
  if (!read(node, mistakes, file, folder)) {
    return false;
  }
  if (is_recording(file)) {
    return read_recording(node, mistakes, table, file);
  }
  CsvRows rows;
  const bool good = read_table(node, mistakes, rows, file, CsvColumns{{"time", "value"}}, TableHead::units);
  for (const auto& row : rows) {
    if (good) {
      table.push_back({row[0], row[1]});
    }
  }
  return good;
}

}  // namespace idiophone::scene

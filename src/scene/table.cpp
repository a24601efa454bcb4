// Tables in CSV files: rows of a time and what belongs to it. Tables of a time and a value can also be sound files.

#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/scene/sections.hpp"
#include "table_header.hpp"

namespace idiophone::scene {

namespace {

constexpr std::size_t most_mistakes = 10;  // a file that is no table at all would bring thousands
constexpr std::string_view blanks = " \t\r";

std::size_t skip_blanks(std::string_view line, std::size_t position) {
  return std::min(line.find_first_not_of(blanks, position), line.size());
}

/// Reads one row and checks it. What is wrong is put into `mistake`, and where into `position`.
bool parse_row(std::string_view line, const CsvColumns& columns, std::vector<double>& row, std::size_t& position,
               std::string& mistake) {
  const std::vector<std::string>& names = columns.names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + position, end, row.emplace_back());
    if (error != std::errc{} || !std::isfinite(row.back())) {
      mistake = fmt::format("expected a {}{}, found '{}'", names[i], i == 0 ? " (s)" : "", line.substr(position));
      return false;
    }
    position = skip_blanks(line, rest - line.data());
    if (i + 1 == names.size()) {
      break;
    }
    if (position == line.size() || line[position] != ',') {
      mistake =
          fmt::format("expected a comma between {} and {}, found '{}'", names[i], names[i + 1], line.substr(position));
      return false;
    }
    position = skip_blanks(line, position + 1);
  }
  if (position != line.size()) {
    mistake = fmt::format("unexpected '{}' after the {}", line.substr(position), names.back());
  }
  return position == line.size();
}

/// What a table may begin with.
enum class TableHead { rows, units };

bool read_rows(std::istream& csv, const std::string& name, Mistakes& mistakes, CsvRows& rows, const CsvColumns& columns,
               TableHead head) {
  const std::size_t before = mistakes.count();
  TableUnits units;
  std::string text;
  for (int number = 1; std::getline(csv, text) && mistakes.count() < before + most_mistakes; ++number) {
    const std::string_view line = std::string_view(text).substr(0, text.find('#'));
    std::size_t position = skip_blanks(line, 0);
    if (position == line.size()) {
      continue;
    }
    const std::size_t start = position;
    if (std::exchange(head, TableHead::rows) == TableHead::units &&
        std::isalpha(static_cast<unsigned char>(line[start])) != 0) {
      const std::size_t last = line.find_last_not_of(blanks);
      units =
          read_table_header(line.substr(start, last + 1 - start), {name, number, static_cast<int>(start) + 1}, mistakes)
              .value_or(units);
      continue;
    }
    std::vector<double> row;
    std::string mistake;
    if (parse_row(line, columns, row, position, mistake)) {
      position = start;
      row[0] *= units.time;
      row[1] *= units.value;
      if (row[0] < 0.0) {
        mistake = fmt::format("the time must be at least 0 s, found {}", row[0]);
      }
      if (!rows.empty() && row[0] <= rows.back()[0]) {
        mistake = fmt::format("times must ascend; {} s does not follow {} s", row[0], rows.back()[0]);
      }
      rows.push_back(row);
    }
    if (!mistake.empty()) {
      mistakes.add({name, number, static_cast<int>(position) + 1}, mistake);
    }
  }
  return mistakes.count() == before;
}

bool read_csv(const Node& node, Mistakes& mistakes, CsvRows& rows, const std::filesystem::path& file,
              const CsvColumns& columns, TableHead head) {
  std::ifstream csv(file);
  if (!csv) {
    return mistakes.add(node, "can't read " + std::filesystem::absolute(file).string());
  }
  if (!read_rows(csv, file.string(), mistakes, rows, columns, head)) {
    return false;
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
  return read(node, mistakes, file, folder) && read_csv(node, mistakes, rows, file, columns, TableHead::rows);
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
  const bool good = read_csv(node, mistakes, rows, file, CsvColumns{{"time", "value"}}, TableHead::units);
  for (const auto& row : rows) {
    if (good) {
      table.push_back({row[0], row[1]});
    }
  }
  return good;
}

}  // namespace idiophone::scene

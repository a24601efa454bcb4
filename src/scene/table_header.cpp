#include "table_header.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <map>
#include <regex>

#include "idiophone/foundation/deck/csv.hpp"

namespace idiophone::scene {

namespace {

struct Unit {
  double factor = 1.0;
  bool is_force = false;
};

const std::map<std::string, Unit, std::less<>>& time_units() {
  static const std::map<std::string, Unit, std::less<>> all = {{"s", {1.0}}, {"ms", {1e-3}}, {"us", {1e-6}}};
  return all;
}

const std::map<std::string, Unit, std::less<>>& value_units() {
  static const std::map<std::string, Unit, std::less<>> all = {
      {"", {1.0}}, {"1", {1.0}}, {"mN", {1e-3, true}}, {"N", {1.0, true}}, {"kN", {1e3, true}}};
  return all;
}

}  // namespace

std::optional<TableUnits> read_table_header(std::string_view line, const deck::Location& where,
                                            deck::Mistakes& mistakes) {
  // A name, and its unit after a slash or in brackets.
  static const std::regex form(R"(time *[/(\[] *(\w*) *[)\]]? *, *[A-Za-z_][A-Za-z_ ]*([/(\[] *(\w*) *[)\]]?)? *)");
  std::match_results<std::string_view::const_iterator> found;
  if (!std::regex_match(line.begin(), line.end(), found, form)) {
    mistakes.add(where, fmt::format("expected a row 'time, value' or a header with units, such as 'time/s, force/N', "
                                    "found '{}'",
                                    line));
    return {};
  }
  const auto time = time_units().find(found[1].str());
  const auto value = value_units().find(found[3].str());
  if (time == time_units().end()) {
    mistakes.add(where, fmt::format("'{}' is no unit of a time here; take s, ms or us", found[1].str()));
  }
  if (value == value_units().end()) {
    mistakes.add(where, fmt::format("'{}' is no unit of a value here; take N, mN, kN or 1", found[3].str()));
  }
  if (time == time_units().end() || value == value_units().end()) {
    return {};
  }
  return TableUnits{time->second.factor, value->second.factor, value->second.is_force};
}

TableUnits units_of_table(const std::string& file) {
  std::ifstream csv = deck::open_csv(file);
  deck::Mistakes known;  // the reader of the table has told them
  for (std::string text; std::getline(csv, text);) {
    const std::string line = text.substr(0, text.find('#'));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos) {
      const std::size_t last = line.find_last_not_of(" \t\r");
      const bool is_header = std::isalpha(static_cast<unsigned char>(line[first])) != 0;
      return is_header ? read_table_header(line.substr(first, last + 1 - first), {}, known).value_or(TableUnits{})
                       : TableUnits{};
    }
  }
  return {};
}

}  // namespace idiophone::scene

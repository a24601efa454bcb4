#include "velocity_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/deck/csv.hpp"

namespace idiophone::harmonic {

namespace {

const std::vector<deck::CsvColumn> columns = {{"frequency", "Hz"}, {"x", "m"},
                                              {"y", "m"},          {"z", "m"},
                                              {"vx", "m/s"},       {"vx_imaginary", "m/s"},
                                              {"vy", "m/s"},       {"vy_imaginary", "m/s"},
                                              {"vz", "m/s"},       {"vz_imaginary", "m/s"}};

std::string header_text() {
  std::string text;
  for (const deck::CsvColumn& column : columns) {
    text += (text.empty() ? "" : ",") + column.name;
  }
  return text;
}

/// A dataset of numbers. Reports a unit that is another one.
std::vector<double> numbers(hid_t file, const std::string& name, const std::string& unit, const hdf5::Dimensions& shape,
                            const std::string& path, deck::Mistakes& mistakes) {
  const auto dataset = hdf5::open_dataset(file, name);
  if (hdf5::shape_of(dataset.id()) != shape) {
    throw std::runtime_error(fmt::format("{} must have the shape [{}]", name, fmt::join(shape, " x ")));
  }
  if (hdf5::has(dataset.id(), "unit") && hdf5::text_of(dataset.id(), "unit") != unit) {
    mistakes.add({path + ":" + name, 1, 1},
                 fmt::format("must be in {}, not {}", unit, hdf5::text_of(dataset.id(), "unit")));
  }
  return hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()));
}

}  // namespace

std::vector<VelocityRow> csv_velocities(const std::filesystem::path& file, deck::Mistakes& mistakes) {
  std::vector<deck::CsvRow> lines;
  std::optional<deck::CsvHeader> header;
  if (deck::read_csv(file, columns, mistakes, lines, &header) && header && header->text != header_text()) {
    mistakes.add(header->where, fmt::format("the columns must be '{}', not '{}'", header_text(), header->text));
  }
  std::vector<VelocityRow> rows;
  for (const auto& [where, values] : lines) {
    rows.push_back(
        {.where = where,
         .frequency = values[0],
         .place = {values[1], values[2], values[3]},
         .velocity = {Complex(values[4], values[5]), Complex(values[6], values[7]), Complex(values[8], values[9])}});
  }
  return rows;
}

std::vector<VelocityRow> hdf5_velocities(const std::filesystem::path& path, deck::Mistakes& mistakes) {
  return files::read_within_limit(path, [&] {
    const auto file = hdf5::open_for_reading(path);
    const auto rows_of = [&](const char* name) { return hdf5::row_count(hdf5::open_dataset(file.id(), name).id()); };
    const hsize_t frequencies = rows_of("/frequency"), points = rows_of("/position");
    const auto read = [&](const char* name, const char* unit, const hdf5::Dimensions& shape) {
      return numbers(file.id(), name, unit, shape, path.string(), mistakes);
    };
    const auto frequency = read("/frequency", "Hz", {frequencies});
    const auto position = read("/position", "m", {points, 3});
    const auto parts = read("/velocity", "m/s", {frequencies, points, 3, 2});
    std::vector<VelocityRow> rows;
    for (std::size_t i = 0; i < frequencies * points; ++i) {
      const double *part = &parts[6 * i], *place = &position[3 * (i % points)];
      VelocityRow& row = rows.emplace_back();
      row.where = {path.string() + ":/velocity", static_cast<int>(i / points) + 1, static_cast<int>(i % points) + 1};
      row.frequency = frequency[i / points];
      row.place = Vector3::Map(place);
      row.velocity = {Complex(part[0], part[1]), Complex(part[2], part[3]), Complex(part[4], part[5])};
      const bool is_finite = std::isfinite(row.frequency) && row.place.allFinite() && row.velocity.allFinite();
      if (!is_finite && mistakes.count() < deck::most_mistakes_of_a_table) {
        mistakes.add(row.where, "frequency, position or velocity is not finite");
      }
    }
    return rows;
  });
}

}  // namespace idiophone::harmonic

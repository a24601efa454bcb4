#include "idiophone/store/series_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "format.hpp"
#include "hdf5_dataset.hpp"
#include "hdf5_group.hpp"
#include "reading.hpp"
#include "series_attributes.hpp"
#include "table_checksums.hpp"

namespace idiophone::store {

struct SeriesReader::State {
  std::filesystem::path path;
  hdf5::Identifier file;
  std::vector<Series> all;

  explicit State(std::filesystem::path result) : path(std::move(result)) {
    read_within_limit(path, [&] { read(); });
  }

  void read() {
    file = hdf5::open_for_reading(path);
    check_format(file.id(), result_format, path);
    for (const std::string& name : hdf5::datasets_below(file.id(), "/")) {
      if (const auto dataset = hdf5::open_dataset(file.id(), name); is_series(dataset.id())) {
        all.push_back(get_series(dataset.id(), name));
      }
    }
  }
};

SeriesReader::SeriesReader(const std::filesystem::path& result) : state_(std::make_unique<State>(result)) {}
SeriesReader::SeriesReader(SeriesReader&&) noexcept = default;
SeriesReader& SeriesReader::operator=(SeriesReader&&) noexcept = default;
SeriesReader::~SeriesReader() = default;

const std::vector<Series>& SeriesReader::all() const {
  return state_->all;
}

std::int64_t SeriesReader::rows(const Series& series) const {
  return read_naming(state_->path, [&] {
    return static_cast<std::int64_t>(hdf5::row_count(hdf5::open_dataset(state_->file.id(), series.path).id()));
  });
}

void SeriesReader::require_intact(const Series& series) const {
  read_within_limit(state_->path, [&] {
    require_intact_table(state_->file.id(), series.path, hdf5::open_dataset(state_->file.id(), series.path).id());
  });
}

std::vector<double> SeriesReader::read(const Series& series, std::int64_t begin, std::int64_t count) const {
  if (const std::int64_t rows = this->rows(series); begin < 0 || count < 0 || begin > rows - count) {
    throw std::runtime_error(
        fmt::format("{}: {} has {} rows, not {} from {} on", state_->path.string(), series.path, rows, count, begin));
  }
  return read_within_limit(state_->path, [&] {
    const auto dataset = hdf5::open_dataset(state_->file.id(), series.path);
    return hdf5::read<double>(dataset.id(),
                              {{static_cast<hsize_t>(begin), 0}, {static_cast<hsize_t>(count), series.columns.size()}});
  });
}

}  // namespace idiophone::store

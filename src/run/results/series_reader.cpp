#include "idiophone/run/results/series_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "series_attributes.hpp"

namespace idiophone::results {

struct SeriesReader::State {
  std::filesystem::path path;
  hdf5::Identifier file;
  std::vector<spectra::Series> all;

  explicit State(std::filesystem::path result) : path(std::move(result)) {
    files::read_within_limit(path, [&] { read(); });
  }

  void read() {
    file = hdf5::open_for_reading(path);
    files::check_format(file.id(), files::result_format, path);
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

std::string SeriesReader::deck() const {
  return files::read_within_limit(state_->path, [&] { return hdf5::text_in(state_->file.id(), "/deck"); });
}

std::vector<std::string> SeriesReader::overrides() const {
  return files::read_within_limit(state_->path, [&] { return hdf5::texts_in(state_->file.id(), "/overrides"); });
}

const std::vector<spectra::Series>& SeriesReader::all() const {
  return state_->all;
}

std::int64_t SeriesReader::rows(const spectra::Series& series) const {
  return files::read_naming(state_->path, [&] {
    return static_cast<std::int64_t>(hdf5::row_count(hdf5::open_dataset(state_->file.id(), series.path).id()));
  });
}

void SeriesReader::require_intact(const spectra::Series& series) const {
  files::read_within_limit(state_->path, [&] {
    files::require_intact_table(state_->file.id(), series.path,
                                hdf5::open_dataset(state_->file.id(), series.path).id());
  });
}

std::vector<double> SeriesReader::read(const spectra::Series& series, std::int64_t begin, std::int64_t count) const {
  if (const std::int64_t rows = this->rows(series); begin < 0 || count < 0 || begin > rows - count) {
    throw std::runtime_error(
        fmt::format("{}: {} has {} rows, not {} from {} on", state_->path.string(), series.path, rows, count, begin));
  }
  return files::read_within_limit(state_->path, [&] {
    const auto dataset = hdf5::open_dataset(state_->file.id(), series.path);
    return hdf5::read<double>(dataset.id(),
                              {{static_cast<hsize_t>(begin), 0}, {static_cast<hsize_t>(count), series.columns.size()}});
  });
}

}  // namespace idiophone::results

#pragma once
// The sounds and motion channels of a finished (or stopped) result by name, without MPI: for commands and scripts.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/foundation/spectra/series.hpp"

namespace idiophone::results {

class SeriesReader {
 public:
  /// @throws std::runtime_error if the file can't be opened, is damaged or is not a result of idiophone
  explicit SeriesReader(const std::filesystem::path& result);
  SeriesReader(SeriesReader&&) noexcept;
  SeriesReader& operator=(SeriesReader&&) noexcept;
  SeriesReader(const SeriesReader&) = delete;
  SeriesReader& operator=(const SeriesReader&) = delete;
  ~SeriesReader();

  /// The deck of the run, verbatim. @throws std::runtime_error if the result is damaged
  [[nodiscard]] std::string deck() const;
  /// The --set arguments of the run, verbatim. @throws likewise
  [[nodiscard]] std::vector<std::string> overrides() const;

  /// Every series of the result, by path.
  [[nodiscard]] const std::vector<spectra::Series>& all() const;

  /// The series of a name, see spectra::find_series().
  /// @throws std::invalid_argument if there is no such series; it names the nearest one
  [[nodiscard]] const spectra::Series& find(const std::string& name) const { return spectra::find_series(all(), name); }

  /// Number of rows of a series.
  [[nodiscard]] std::int64_t rows(const spectra::Series& series) const;

  /// @throws std::runtime_error if the rows of a series are damaged
  void require_intact(const spectra::Series& series) const;

  /// Some rows of a series.
  /// @return [columns x count], a row's columns side by side
  /// @throws std::runtime_error if there are fewer rows
  [[nodiscard]] std::vector<double> read(const spectra::Series& series, std::int64_t begin, std::int64_t count) const;

  /// All rows of a series, [columns x rows].
  [[nodiscard]] std::vector<double> read(const spectra::Series& series) const { return read(series, 0, rows(series)); }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::results

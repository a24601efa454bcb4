#pragma once
// Named tables that grow at a fixed rate: sounds and motion channels, in memory during a run as in a result file.

#include <array>
#include <string>
#include <vector>

namespace idiophone::spectra {

/// A table that grows by rows of double numbers at a fixed rate. The same on all ranks.
struct Series {
  std::string path;                              ///< e.g. "/audio/ears"
  std::string unit;                              ///< of its values, e.g. "Pa m"
  double rate = 0.0;                             ///< rows per second, Hz
  std::vector<std::string> columns;              ///< one name each, at least one
  std::string description;                       ///< one sentence for the reader of the file
  std::vector<std::array<double, 3>> positions;  ///< of each column's receiver, m; empty if there is none
  std::string attached = {};                     ///< of a sound: the body that carries the receivers; empty for none
};

/// Finds a series by its name.
/// @param name  its path; the first slash can be omitted: "contacts/blow/force"
/// @throws std::invalid_argument if there is no such series; it names the nearest one
[[nodiscard]] const Series& find_series(const std::vector<Series>& all, const std::string& name);

}  // namespace idiophone::spectra

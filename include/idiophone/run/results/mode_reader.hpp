#pragma once
// Reading modes back from a file of `idiophone modes`, without MPI.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace idiophone::results {

/// The modes of one body, ascending.
struct StoredModes {
  std::string body;
  std::vector<double> frequencies;  ///< [modes] Hz
  std::vector<double> decay_times;  ///< [modes] T60, s; infinity without damping
  std::vector<double> mesh_errors;  ///< [modes] estimated, cents; NaN where unknown. Empty if unknown for all
  std::optional<std::vector<std::string>>
      kinds;                                ///< [modes] empty texts where there is none; older programs wrote none
  std::vector<std::vector<double>> shapes;  ///< [modes][3 x nodes of its mesh] m
};

/// The modes of each body that has some.
/// @throws std::runtime_error if the file can't be opened, is damaged or is not a result of idiophone
[[nodiscard]] std::vector<StoredModes> read_modes(const std::filesystem::path& modes);

}  // namespace idiophone::results

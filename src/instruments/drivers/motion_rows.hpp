#pragma once
// Rows of a result's channels, and forces that are made of them.

#include <cstddef>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/event.hpp"
#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::drivers {

inline constexpr double gap_of_touches = 0.01;  ///< s: what begins earlier after an excitation belongs to it

/// A channel of vectors.
struct VectorChannel {
  std::size_t width;
  double rate;  ///< rows per second
  std::vector<double> values;

  /// @throws std::invalid_argument if there is no such channel; std::runtime_error if it is damaged
  VectorChannel(const results::SeriesReader& reader, const std::string& name);

  [[nodiscard]] std::size_t rows() const { return values.size() / width; }
  [[nodiscard]] Vector3 vector(std::size_t row) const { return Vector3::Map(&values[width * row]); }
};

/// Adds one row of a force. @param rate  rows per second
void add_row(double newtons, double rate, Strength& strength);

/// A force that is constant during each row, from row `begin` on; place and direction are left to the caller.
/// @param row_rate  rows per second
[[nodiscard]] resonators::PointForce force_of_rows(const std::vector<double>& rows, std::size_t begin, double row_rate,
                                                   int rate);

}  // namespace idiophone::drivers

#include "motion_rows.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::drivers {

VectorChannel::VectorChannel(const results::SeriesReader& reader, const std::string& name) {
  const spectra::Series& series = reader.find(name);
  reader.require_intact(series);
  width = series.columns.size();
  rate = series.rate;
  values = reader.read(series);
}

void add_row(double newtons, double rate, Strength& strength) {
  strength.force = std::max(strength.force, newtons);
  strength.impulse += newtons / rate;
}

resonators::PointForce force_of_rows(const std::vector<double>& rows, std::size_t begin, double row_rate, int rate) {
  resonators::PointForce force;
  if (row_rate == rate) {
    force.start = static_cast<std::int64_t>(begin);
    for (const double row : rows) {
      force.force.push_back({.mean = row, .slope = 0.0, .begin = row});
    }
    return force;
  }
  const double samples = rate / row_rate;  // in a row
  const double first = samples * static_cast<double>(begin);
  force.start = static_cast<std::int64_t>(std::floor(first));
  const double lead = first - std::floor(first);
  force.force.resize(static_cast<std::size_t>(std::ceil(lead + samples * static_cast<double>(rows.size()))));
  for (std::size_t row = 0; row < rows.size(); ++row) {  // its mean over each sample
    const double from = lead + samples * static_cast<double>(row), to = from + samples;
    for (auto n = static_cast<std::size_t>(from); n < force.force.size() && static_cast<double>(n) < to; ++n) {
      const auto sample = static_cast<double>(n);
      force.force[n].mean += rows[row] * std::max(0.0, std::min(to, sample + 1.0) - std::max(from, sample));
    }
  }
  for (resonators::ForcePiece& piece : force.force) {
    piece.begin = piece.mean;
  }
  return force;
}

}  // namespace idiophone::drivers

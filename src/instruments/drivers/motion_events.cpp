// Forces that follow the motion channels of a result.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/deck/suggestion.hpp"
#include "idiophone/instruments/drivers/motion_drivers.hpp"
#include "motion_rows.hpp"

namespace idiophone::drivers {

namespace {

constexpr std::size_t samples_in_piece = 1024;  // audio samples

/// One number for each row.
struct ChannelRows {
  double rate = 0.0;  // rows per second
  std::vector<double> values;

  [[nodiscard]] double at(double time) const {
    const double place = std::clamp(time * rate, 0.0, static_cast<double>(values.size() - 1));
    const auto row = std::min(static_cast<std::size_t>(place), values.size() > 1 ? values.size() - 2 : 0);
    const double next = values[std::min(row + 1, values.size() - 1)];
    return values[row] + (place - static_cast<double>(row)) * (next - values[row]);
  }
};

ChannelRows rows_of(const results::SeriesReader& reader, const score::MotionForce& force) {
  const spectra::Series& series = reader.find(force.channel);
  const VectorChannel channel(reader, force.channel);
  const auto column = std::ranges::find(series.columns, force.column);
  if (!force.column.empty() && column == series.columns.end()) {
    throw std::runtime_error(fmt::format("{} has no column '{}'{}", series.path, force.column,
                                         deck::suggestion(force.column, series.columns)));
  }
  if (channel.rows() == 0) {
    throw std::runtime_error(series.path + " has no rows");
  }
  ChannelRows rows{.rate = channel.rate, .values = {}};
  for (std::size_t row = 0; row < channel.rows(); ++row) {
    const auto numbers = Eigen::Map<const Eigen::VectorXd>(&channel.values[channel.width * row],
                                                           static_cast<Eigen::Index>(channel.width));
    const bool is_column = column != series.columns.end();
    rows.values.push_back(is_column            ? numbers[column - series.columns.begin()]
                          : channel.width == 1 ? numbers[0]
                                               : numbers.norm());
  }
  return rows;
}

/// The value at each audio sample, and zero where it is not above the threshold.
std::vector<double> samples_of(const ChannelRows& rows, double above, int rate) {
  std::vector<double> samples(
      static_cast<std::size_t>(std::ceil(static_cast<double>(rows.values.size() - 1) / rows.rate * rate)));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double value = rows.at(static_cast<double>(n) / rate);
    samples[n] = std::abs(value) > above ? value : 0.0;
  }
  return samples;
}

/// Pieces of one run of samples that are not zero.
void add_run(const std::vector<double>& samples, std::size_t begin, std::size_t end, const score::MotionForce& force,
             int rate, std::vector<Event>& events) {
  Strength strength;
  for (std::size_t n = begin; n < end; ++n) {
    add_row(std::abs(samples[n]) * force.force.norm(), rate, strength);
  }
  for (std::size_t first = begin; first < end; first += samples_in_piece) {
    const std::size_t last = std::min(first + samples_in_piece, end);
    Excitation excitation{
        .forces = {{.start = static_cast<std::int64_t>(first), .at = force.at, .direction = force.force, .force = {}}},
        .strength = strength,
        .begins = first == begin};
    for (std::size_t n = first; n < last; ++n) {
      const double next = n + 1 < end ? samples[n + 1] : samples[n];
      excitation.forces.front().force.push_back(resonators::linear_piece(samples[n], next));
    }
    events.push_back({.start = static_cast<std::int64_t>(first), .body = force.body, .action = std::move(excitation)});
  }
}

}  // namespace

std::vector<Event> motion_events(const std::filesystem::path& result, const std::vector<score::MotionForce>& forces,
                                 int rate) {
  const results::SeriesReader reader(result);
  std::vector<Event> events;
  for (const score::MotionForce& force : forces) {
    const std::vector<double> samples = samples_of(rows_of(reader, force), force.above, rate);
    for (std::size_t begin = 0; begin < samples.size(); ++begin) {
      if (samples[begin] == 0.0) {
        continue;
      }
      const auto stop = std::find(samples.begin() + static_cast<std::ptrdiff_t>(begin), samples.end(), 0.0);
      const auto end = static_cast<std::size_t>(stop - samples.begin());
      add_run(samples, begin, end, force, rate, events);
      begin = end;
    }
  }
  return events;
}

}  // namespace idiophone::drivers

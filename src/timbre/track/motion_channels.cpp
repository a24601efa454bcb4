#include "idiophone/timbre/track/motion_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::timbre {

namespace {

/// One number for each row.
std::vector<double> column_of(const spectra::Series& series, const std::vector<double>& rows,
                              const timbre::MotionVariable& variable) {
  const std::size_t width = series.columns.size();
  const auto column = std::ranges::find(series.columns, variable.column);
  if (!variable.column.empty() && column == series.columns.end()) {
    throw deck::DeckError(variable.where, fmt::format("{} has no column '{}'{}", series.path, variable.column,
                                                      deck::suggestion(variable.column, series.columns)));
  }
  std::vector<double> values(rows.size() / width);
  for (std::size_t r = 0; r < values.size(); ++r) {
    const auto row = std::span(rows).subspan(r * width, width);
    if (column != series.columns.end()) {
      values[r] = row[column - series.columns.begin()];
    } else if (width == 1) {
      values[r] = row[0];
    } else {
      double square = 0.0;
      for (const double component : row) {
        square += component * component;
      }
      values[r] = std::sqrt(square);
    }
  }
  return values;
}

/// By central differences, and one-sided ones at the ends.
std::vector<double> derivative_of(const std::vector<double>& values, double rate) {
  std::vector<double> slopes(values.size());
  const std::size_t last = values.size() - 1;
  for (std::size_t i = 0; i < values.size() && last > 0; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, last);
    slopes[i] = (values[after] - values[before]) * rate / static_cast<double>(after - before);
  }
  return slopes;
}

}  // namespace

MotionChannels::MotionChannels(const std::optional<std::filesystem::path>& result) {
  if (result) {
    reader_.emplace(*result);
  }
}

MotionChannels::MotionChannels(std::vector<spectra::Series> channels, const MotionRows& rows)
    : channels_(std::move(channels)), rows_(&rows) {}

MotionChannels::MotionChannels(std::vector<spectra::Series> channels, std::set<std::string>& named)
    : channels_(std::move(channels)), named_(&named) {}

const spectra::Series& MotionChannels::find(const timbre::MotionVariable& variable) const {
  if (!reader_ && rows_ == nullptr && named_ == nullptr) {
    throw deck::DeckError(variable.where, "this needs the motion of a run; give its result NAME.h5 after the scene");
  }
  try {
    return reader_ ? reader_->find(variable.channel) : spectra::find_series(channels_, variable.channel);
  } catch (const std::invalid_argument& error) {
    throw deck::DeckError(variable.where, error.what());
  }
}

std::vector<double> MotionChannels::rows_of(const spectra::Series& series) const {
  if (named_ != nullptr) {
    named_->insert(series.path);
    return std::vector<double>(series.columns.size());
  }
  if (rows_ != nullptr) {
    return rows_->at(series.path);
  }
  reader_->require_intact(series);
  return reader_->read(series);
}

ChannelValues MotionChannels::values(const timbre::MotionVariable& variable) const {
  const spectra::Series& series = find(variable);
  ChannelValues found{.rate = series.rate, .values = column_of(series, rows_of(series), variable)};
  if (found.values.empty()) {
    throw deck::DeckError(variable.where, series.path + " has no rows");
  }
  if (variable.derivative) {
    found.values = derivative_of(found.values, found.rate);
  }
  for (double& value : found.values) {
    value = variable.mapping(value);
    if (!std::isfinite(value)) {
      throw deck::DeckError(variable.where, series.path + " has values that are not finite");
    }
  }
  return found;
}

std::vector<ContactEvent> MotionChannels::contacts(const timbre::ContactStart& start) const {
  const ChannelValues force = values({.channel = "contacts/" + start.contact + "/force", .where = start.where});
  if (named_ != nullptr) {
    return {ContactEvent{.force = start.above, .impulse = start.above / force.rate}};
  }
  std::vector<ContactEvent> events;
  double last_above = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < force.values.size(); ++i) {
    const double time = static_cast<double>(i) / force.rate;
    const double newtons = force.values[i];
    if (newtons > start.above) {
      if (time - last_above > start.gap) {
        events.push_back({.time = time});
      }
      last_above = time;
      events.back().force = std::max(events.back().force, newtons);
      events.back().impulse += newtons / force.rate;
    }
  }
  return events;
}

}  // namespace idiophone::timbre

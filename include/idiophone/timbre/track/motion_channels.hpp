#pragma once
// The motion channels of a run, as functions of time: from its result, or in memory.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "idiophone/foundation/spectra/series.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

namespace idiophone::timbre {

/// A contact, from when its force rose above a threshold to when it stayed below.
struct ContactEvent {
  double time = 0.0;     ///< when it began, s
  double force = 0.0;    ///< largest, N
  double impulse = 0.0;  ///< integral of the force, N s
};

/// The rows of a channel as one number each.
struct ChannelValues {
  double rate = 0.0;  ///< rows per second; row 0 is at time 0
  std::vector<double> values;
};

/// The rows of some channels by the channel's path, [columns x rows] each.
using MotionRows = std::map<std::string, std::vector<double>>;

class MotionChannels {
 public:
  /// @param result  NAME.h5; without one, every channel is a mistake
  /// @throws std::runtime_error if it can't be read
  explicit MotionChannels(const std::optional<std::filesystem::path>& result);

  /// The motion of a run in memory.
  /// @param channels  all that the run has
  /// @param rows      of those that will be asked for; must outlive this object
  MotionChannels(std::vector<spectra::Series> channels, const MotionRows& rows);

  /// A run that begins. Each channel has a row of zeros, and each contact an event, so that everything that does not
  /// depend on numbers can be checked.
  /// @param named  gets the paths of the channels that are asked for; must outlive this object
  MotionChannels(std::vector<spectra::Series> channels, std::set<std::string>& named);

  /// A column, or the length of the vector of all columns, or the derivative of this, mapped.
  /// @throws deck::DeckError if there is no such channel or column, with the nearest name
  [[nodiscard]] ChannelValues values(const timbre::MotionVariable& variable) const;

  /// Contacts above a force, from the channel contacts/NAME/force.
  /// @throws deck::DeckError if there is no such contact
  [[nodiscard]] std::vector<ContactEvent> contacts(const timbre::ContactStart& start) const;

 private:
  [[nodiscard]] const spectra::Series& find(const timbre::MotionVariable& variable) const;
  [[nodiscard]] std::vector<double> rows_of(const spectra::Series& series) const;

  std::optional<results::SeriesReader> reader_;
  std::vector<spectra::Series> channels_;   ///< of a run in memory
  const MotionRows* rows_ = nullptr;        ///< of a run in memory
  std::set<std::string>* named_ = nullptr;  ///< of a run that begins
};

}  // namespace idiophone::timbre

#pragma once
// The motion channels of a result, as functions of time.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

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

/// Whether the rows of a result are there, or a run that begins will append them. Until then each channel has a row of
/// zeros, and each contact an event, so that everything that does not depend on numbers can be checked.
enum class MotionRows { recorded, to_come };

class MotionChannels {
 public:
  /// @param result  NAME.h5; without one, every channel is a mistake
  /// @throws std::runtime_error if it can't be read
  explicit MotionChannels(const std::optional<std::filesystem::path>& result, MotionRows rows = MotionRows::recorded);

  /// A column, or the length of the vector of all columns, mapped.
  /// @throws deck::DeckError if there is no such channel or column, with the nearest name
  [[nodiscard]] ChannelValues values(const timbre::MotionVariable& variable) const;

  /// Contacts above a force, from the channel contacts/NAME/force.
  /// @throws deck::DeckError if there is no such contact
  [[nodiscard]] std::vector<ContactEvent> contacts(const timbre::ContactStart& start) const;

 private:
  [[nodiscard]] const spectra::Series& find(const timbre::MotionVariable& variable) const;
  [[nodiscard]] std::vector<double> rows_of(const spectra::Series& series) const;

  std::optional<results::SeriesReader> reader_;
  MotionRows rows_;
};

}  // namespace idiophone::timbre

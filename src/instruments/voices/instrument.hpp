#pragma once
// One body in the control thread: its sound map, from which come the resonators, the commands of blows, and what
// receivers hear.

#include <memory>
#include <span>
#include <vector>

#include "audio_commands.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/audience.hpp"
#include "prepared_map.hpp"

namespace idiophone::voices {

class Instrument {
 public:
  /// Modes from half of the rate on, and those that do not oscillate or take an hour for it, are silent.
  Instrument(std::shared_ptr<const PreparedMap> prepared, int rate);

  /// Changes size and internal friction of the body. A body of the same material that is s times as long has
  /// frequencies and decay rates 1/s times as high, shapes of modes s^(-3/2) times as large, and pressures s^(-1/2)
  /// times as large.
  void tune(const score::Tuning& tuning);

  [[nodiscard]] const sound_maps::SoundMap& map() const { return *prepared_->map; }
  [[nodiscard]] const std::shared_ptr<const PreparedMap>& prepared() const { return prepared_; }
  [[nodiscard]] int rate() const { return rate_; }
  /// That are not silent.
  [[nodiscard]] std::size_t modes() const;

  /// The modes at rest, as the map has them.
  [[nodiscard]] resonators::ResonatorBank bank() const;

  /// Resonator::turn of each mode.
  [[nodiscard]] std::vector<resonators::Complex> turns() const;

  /// A force at the nearest point of the surface. Start and time of sending are left to the caller.
  /// @param direction  by which the force is multiplied
  [[nodiscard]] std::unique_ptr<ForceCommand> excite(const Vector3& at, const Vector3& direction,
                                                     resonators::ForceCurve force) const;

  /// @throws std::runtime_error when no mode sounds, so that nothing can touch it
  void require_modes() const;

  /// The nearest point of the surface. @param direction  unit vector
  [[nodiscard]] resonators::ContactPoint contact_point(const Vector3& at, const Vector3& direction) const;

  /// Start and number are left to the caller. @throws std::runtime_error when no mode sounds
  [[nodiscard]] std::unique_ptr<TouchCommand> touch(const score::Bow& bow) const;
  [[nodiscard]] std::unique_ptr<TouchCommand> touch(const score::MalletBlow& mallet) const;

  /// At the listeners of the map, which must be 1 to most_receivers.
  [[nodiscard]] Reception at_listeners() const;

  /// At any points, by the far field of the map: pressure falls with 1/distance from the body's centre, and is that of
  /// the surrounding directions. Points within the body's radius count as on it.
  /// @param points  1 to most_receivers
  [[nodiscard]] Reception at(std::span<const HearingPoint> points) const;

 private:
  [[nodiscard]] Reception reception(std::span<const std::vector<resonators::Complex>> pressure,
                                    std::span<const double> delay) const;

  /// phi at a place, [modes].
  [[nodiscard]] std::vector<double> participation(const Vector3& at, const Vector3& direction) const;

  /// Without the contact and its length.
  [[nodiscard]] std::unique_ptr<TouchCommand> touch_at(const Vector3& at, const Vector3& direction) const;

  std::shared_ptr<const PreparedMap> prepared_;
  int rate_;
  double size_ = 1.0;                              // times the lengths of the map
  std::vector<resonators::Resonator> resonators_;  // [modes of the map]
  double lowest_ = 0.0;                            // angular frequency of the modes that sound, rad/s; 0 without any
};

}  // namespace idiophone::voices

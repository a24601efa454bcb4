#pragma once
// One sound map on the stage. The control thread's part: what is asked for becomes commands to the player, in the order
// of their times.

#include <deque>
#include <memory>
#include <vector>

#include "idiophone/instruments/voices/audience.hpp"
#include "idiophone/instruments/voices/map_detail.hpp"
#include "idiophone/instruments/voices/voice.hpp"
#include "instrument.hpp"
#include "player.hpp"

namespace idiophone::voices {

class MapBody {
 public:
  /// @param points  none: at the listeners of the map
  /// @throws std::runtime_error when it is too far away
  MapBody(std::shared_ptr<const PreparedMap> map, const Audience& audience, std::vector<HearingPoint> points, int rate,
          const MapDetail& detail);

  [[nodiscard]] const sound_maps::SoundMap& map() const { return instrument_.map(); }
  [[nodiscard]] const std::shared_ptr<const PreparedMap>& prepared() const { return instrument_.prepared(); }

  /// As those of Voice.
  void require_in_reach(const Vector3& place) const;
  void excite(const drivers::Excitation& excitation, std::int64_t sent);
  void tune(const score::Tuning& tuning, std::int64_t start);
  /// @throws std::runtime_error when too many contacts act on the body
  void touch(const drivers::Touching& touch, std::int64_t start);
  void lead(const drivers::TouchLead& lead, std::int64_t start);
  void hear_at(const ListenerPlace& place);
  void attend();

  /// It fades to silence at once, until Player::has_left(). What waits to be sent, or is asked for later, is not heard.
  void leave();

  /// See Instrument. @throws std::runtime_error when no mode sounds
  [[nodiscard]] resonators::ContactPoint contact_point(const Vector3& at, const Vector3& direction) const;

  /// The audio thread's part.
  [[nodiscard]] Player& player() { return player_; }
  [[nodiscard]] const Player& player() const { return player_; }

 private:
  /// A contact that goes on.
  struct Contact {
    std::int64_t command;  ///< number of the TouchCommand
    std::int64_t touch;    ///< number of the drivers::Touching
    std::int64_t end;      ///< audio sample
    std::int64_t rest;     ///< as TouchCommand::rest
    Vector3 at, direction;
  };
  void queue_change(std::int64_t start, std::int64_t length);
  [[nodiscard]] Reception reception() const;
  [[nodiscard]] Reception first_reception() const;

  Instrument instrument_;
  Audience audience_;
  std::vector<HearingPoint> points_;  // where the listener is, or goes
  double behind_;
  Player player_;
  std::deque<Command> queued_;  // not sent yet
  std::vector<Contact> contacts_;
  std::int64_t touches_ = 0;  // so far
};

}  // namespace idiophone::voices

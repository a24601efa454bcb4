#include "idiophone/instruments/voices/sound_map_voice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/place_text.hpp"
#include "idiophone/instruments/voices/arrivals.hpp"
#include "instrument.hpp"
#include "listener_change.hpp"
#include "player.hpp"

namespace idiophone::voices {

namespace {

/// What receivers hear of a body at some points, or the listeners of its map without points.
Reception reception_at(const Instrument& instrument, const Audience& audience,
                       const std::vector<HearingPoint>& points) {
  Reception reception = points.empty() ? instrument.at_listeners() : instrument.at(points);
  if (audience.has_head()) {
    reception.head = audience.head_responses(instrument.map().centre, points.front());
  }
  return reception;
}

/// As it is at the beginning. @throws std::runtime_error when it is too far away
Reception first_reception(const Instrument& instrument, const Audience& audience,
                          const std::vector<HearingPoint>& points) {
  Reception reception = reception_at(instrument, audience, points);
  for (std::size_t r = 0; r < std::max<std::size_t>(1, points.empty() ? audience.receivers() : points.size()); ++r) {
    const double way = reception.delay.at(r) / instrument.rate();
    if (way > longest_way) {
      throw std::runtime_error(fmt::format("a listener is {:.4g} s of sound away from {}; at most {} s can be played",
                                           way, instrument.map().body, longest_way));
    }
  }
  return reception;
}

/// The control thread's part: what is asked for becomes commands to the player, in the order of their times.
class SoundMapVoice : public Voice {
 public:
  /// @param points  none: at the listeners of the map
  SoundMapVoice(std::shared_ptr<const sound_maps::SoundMap> map, const Audience& audience,
                std::vector<HearingPoint> points, int rate)
      : bodies_({map->body}),
        instrument_(std::move(map), rate),
        audience_(audience),
        points_(std::move(points)),
        player_(MappedSound(instrument_.turns(), audience.receivers(), first_reception(instrument_, audience, points_),
                            longest_way * rate),
                audience.receivers(), rate) {}

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return bodies_; }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t /*body*/) const override { return instrument_.map().centre; }

  void require_tunable(std::size_t /*body*/, const score::Tuning& tuning) const override {
    if (tuning.tension != 1.0) {
      throw std::runtime_error("tune: only proxies have a tension; sound maps have size and friction");
    }
  }

  void require_in_reach(const Vector3& place) const override {
    if ((place - instrument_.map().centre).norm() > 0.99 * longest_way * instrument_.map().air_speed) {
      throw std::runtime_error(
          fmt::format("{} is too far away from {} for a listener", to_text(place), instrument_.map().body));
    }
  }

  void excite(std::size_t /*body*/, const drivers::Excitation& excitation, std::int64_t sent) override {
    if (sent != 0 && !queued_.empty()) {
      throw std::runtime_error("too much is played at once");
    }
    for (const resonators::PointForce& force : excitation.forces) {
      std::unique_ptr<ForceCommand> command = instrument_.excite(force.at, force.direction, force.force);
      command->start = force.start;
      command->sent = excitation.forces.size() == 1 ? sent : 0;
      queued_.emplace_back(std::move(command));
    }
    attend();
  }

  /// What is heard of the modes changes, too, but on a path the next piece does that.
  void tune(std::size_t /*body*/, const score::Tuning& tuning, std::int64_t start) override {
    if (queued_.size() >= most_queued) {
      throw std::runtime_error("too many changes of a body are waiting");
    }
    instrument_.tune(tuning);
    auto retuning = std::make_unique<Retuning>();
    retuning->start = start;
    retuning->turns = resonators::in_groups(instrument_.turns());
    queued_.emplace_back(std::move(retuning));
    if (!audience_.moves()) {
      queue_change(start, change_length);
    }
    attend();
  }

  void hear_at(const ListenerPlace& place) override {
    points_ = place.points;
    queue_change(place.start, place.length);
    attend();
  }

  void attend() override {
    player_.collect();
    while (!queued_.empty() && player_.send(queued_.front())) {
      queued_.pop_front();
    }
  }

  [[nodiscard]] VoiceReport report() const override { return {.waits = player_.waits()}; }

  void render(std::span<double> sound, std::int64_t clock) override { player_.render(sound, clock); }

 private:
  void queue_change(std::int64_t start, std::int64_t length) {
    auto change = std::make_unique<ReceptionChange>();
    change->start = start;
    change->length = length;
    change->reception = reception_at(instrument_, audience_, points_);
    queued_.emplace_back(std::move(change));
  }

  static constexpr std::size_t most_queued = 4096;

  std::vector<std::string> bodies_;
  Instrument instrument_;
  Audience audience_;
  std::vector<HearingPoint> points_;  // where the listener is, or goes
  Player player_;
  std::deque<Command> queued_;  // not sent yet
};

}  // namespace

Audience audience_of(const std::vector<sound_maps::SoundMap>& maps) {
  const sound_maps::SoundMap& first = maps.front();
  if (first.listeners.empty() || first.listeners.size() > most_receivers) {
    throw std::runtime_error(
        fmt::format("the sound map of {} has {} receivers; 1 to {} can be played. Give a listener in the score",
                    first.body, first.listeners.size(), most_receivers));
  }
  for (const sound_maps::SoundMap& map : maps) {
    if (!std::ranges::equal(first.listeners, map.listeners, [](const auto& a, const auto& b) {
          return a.name == b.name && a.position == b.position;
        })) {
      throw std::runtime_error(fmt::format(
          "the sound maps of {} and {} have different listeners; give a listener in the score", first.body, map.body));
    }
  }
  std::vector<HearingPoint> points;
  for (const sound_maps::MapListener& listener : first.listeners) {
    points.push_back({.position = listener.position});
  }
  return Audience(std::move(points));
}

std::vector<std::unique_ptr<Voice>> sound_map_voices(std::vector<sound_maps::SoundMap> maps, const Audience& audience,
                                                     int rate) {
  std::vector<std::shared_ptr<const sound_maps::SoundMap>> shared;
  for (sound_maps::SoundMap& map : maps) {
    shared.push_back(std::make_shared<const sound_maps::SoundMap>(std::move(map)));
  }
  return sound_map_voices(shared, audience, rate);
}

std::vector<std::unique_ptr<Voice>> sound_map_voices(
    const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps, const Audience& audience, int rate) {
  const std::vector<HearingPoint> points = audience.is_fixed() ? std::vector<HearingPoint>{} : audience.points(0.0);
  std::vector<std::unique_ptr<Voice>> voices;
  for (const auto& map : maps) {
    voices.push_back(std::make_unique<SoundMapVoice>(map, audience, points, rate));
  }
  return voices;
}

double shortest_delay() {
  return Arrivals::nearest();
}

}  // namespace idiophone::voices

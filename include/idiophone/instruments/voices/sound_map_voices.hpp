#pragma once
// Sound maps as a voice of many bodies: each mode is a resonator. The sounds of all bodies are added up on their way to
// a receiver. The audio thread's part never locks, allocates or frees.

#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/outputs/ring.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/arrivals.hpp"
#include "idiophone/instruments/voices/map_detail.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

class MapBody;
class MapCosts;
class Roster;
struct Lineup;

class SoundMapVoices : public Voice {
 public:
  /// @param maps      bodies can share a map
  /// @param audience  audience_of() the maps, or another; must have somebody
  /// @param rate      audio samples per second; modes from half of it on are left out
  /// @param detail    what is left out; nothing as long as the budget has no limit
  /// @param contacts  of the bodies, by their numbers
  /// @throws std::runtime_error when a map is too far away, or has too many contacts
  SoundMapVoices(const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps, const Audience& audience,
                 int rate, const MapDetail& detail = {}, std::span<const score::BodyContact> contacts = {});
  ~SoundMapVoices() override;

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return names_; }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t body) const override;
  void require_tunable(std::size_t body, const score::Tuning& tuning) const override;
  void require_in_reach(const Vector3& place) const override;
  void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) override;
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) override;
  void require_touchable(std::size_t /*body*/) const override {}
  void touch(std::size_t body, const drivers::Touching& touch, std::int64_t start) override;
  void lead(std::size_t body, const drivers::TouchLead& lead, std::int64_t start) override;
  /// The priority of a body for Priority::fixed, and the budget. @throws std::runtime_error for what only proxies have
  void set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) override;
  void set_budget(double budget, std::int64_t start) override;
  void hear_at(const ListenerPlace& place) override;
  /// Of one body: where the listener is in the coordinates of the body, which moves.
  void hear_at(std::size_t body, const ListenerPlace& place);
  void attend() override;
  [[nodiscard]] VoiceReport report() const override;
  void render(std::span<double> sound, std::int64_t clock) override;

  /// Whether no body has this number, or fades with it.
  [[nodiscard]] bool is_free(std::size_t number) const;

  /// A body joins. attend() hands all that joined to the audio thread at once. No contacts of a score may touch the
  /// voices.
  /// @param number  one that is free
  /// @param points  the listener's places in the coordinates of the body, m: 1 to most_receivers, as many as the others
  ///   have
  /// @throws std::runtime_error when it is too far away, or a head hears the voices
  void add(std::size_t number, const std::shared_ptr<const sound_maps::SoundMap>& map,
           std::vector<HearingPoint> points);

  /// A body fades within MapChoice::interval and leaves; its number is free then, and can't be used before.
  /// @throws std::runtime_error when a head hears the voices
  void remove(std::size_t body);

  /// What a body that moves costs while forces act on it, as it is estimated: processor time per time of sound.
  [[nodiscard]] double cost_of_driven(std::size_t body) const;

  /// Whether a body was silent, or anything of it was heard or faded, after the last choice.
  [[nodiscard]] bool is_heard(std::size_t body) const;

  /// What was chosen since the last call, by the control thread. The newest are lost if attend() is not called for
  /// long.
  [[nodiscard]] std::vector<MapChoice> take_choices();

 private:
  /// A change of what may be heard.
  struct DetailChange {
    std::int64_t start = 0;  // audio sample
    std::size_t body = 0;
    score::Detail detail;
  };
  static constexpr std::size_t most_changes = 64;

  [[nodiscard]] MapBody& body(std::size_t number) const;
  void require_no_head() const;
  void choose(Lineup& lineup);
  void send(Lineup& lineup, std::size_t samples);

  std::vector<std::string> names_;
  std::unique_ptr<Roster> roster_;
  std::unique_ptr<MapCosts> costs_;
  Audience audience_;
  MapDetail detail_;
  std::size_t channels_;
  int rate_;
  std::deque<DetailChange> queued_;  // not sent yet
  std::vector<MapChoice> told_;      // choices that were not taken
  outputs::Ring<DetailChange> incoming_{most_changes};
  outputs::Ring<MapChoice> choices_{4096};
  // of the audio thread
  std::vector<DetailChange> changes_;  // that are not due, in the order of their arrival
  std::vector<Arrivals> arrivals_;     // [channels]; none with a head, which hears each body by itself
  std::int64_t now_ = 0;               // audio sample that is rendered next
};

/// The maps, each for one body.
[[nodiscard]] std::vector<std::shared_ptr<const sound_maps::SoundMap>> shared_maps(
    std::vector<sound_maps::SoundMap> maps);

/// The listeners of sound maps, at which they are heard with their near field.
/// @throws std::runtime_error when maps have different listeners, or more than can be played
[[nodiscard]] Audience audience_of(const std::vector<sound_maps::SoundMap>& maps);

/// The shortest delay of sound from a body to a receiver, audio samples: nearer receivers hear it as late.
[[nodiscard]] double shortest_delay();

}  // namespace idiophone::voices

#pragma once
// Bodies that touch each other, in the audio thread. They are computed together, sample by sample. A body that touches
// no other is a group of its own.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/bodies_in_contact.hpp"
#include "idiophone/instruments/resonators/elastic_contact.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "map_body.hpp"

namespace idiophone::voices {

/// A contact that stays, and where it touches the bodies of its group.
struct StageContact {
  /// One or two points; the number of the body is that in the group.
  struct Point {
    std::size_t body;
    resonators::ContactPoint point;
  };
  std::unique_ptr<resonators::ElasticContact> contact;
  std::vector<Point> points;
};

class ContactGroup {
 public:
  /// @param players  of the bodies
  ContactGroup(std::vector<Player*> players, std::vector<StageContact> contacts, std::size_t channels, int rate);

  /// The next piece of all bodies. Realtime-safe. The parameters are those of SoundMapVoices::render().
  /// @param begin  audio sample of the piece
  void render(std::span<double> sound, std::int64_t begin, std::int64_t clock);

 private:
  [[nodiscard]] bool is_idle() const;
  [[nodiscard]] bool is_called() const;
  void render_samples(std::int64_t sample, std::span<double> sound);

  std::vector<Player*> players_;
  std::vector<StageContact> stage_contacts_;
  std::size_t channels_;
  resonators::PointContacts contacts_;                 // those of the stage, and those that come and go
  bool sleeps_ = false;                                // idle since its last piece began
  std::vector<resonators::BodyInContact> in_contact_;  // [players] in the present samples
};

/// All bodies, in groups of those that touch each other.
/// @throws std::runtime_error when a body has too many points of contact, or no mode that sounds
[[nodiscard]] std::vector<std::unique_ptr<ContactGroup>> contact_groups(
    std::span<const std::unique_ptr<MapBody>> bodies, std::span<const score::BodyContact> contacts,
    std::size_t channels, int rate);

}  // namespace idiophone::voices

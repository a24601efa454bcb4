#include "idiophone/instruments/voices/sound_map_voices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "contact_group.hpp"
#include "idiophone/solids/modal_bodies/rotation_limit.hpp"
#include "map_body.hpp"
#include "map_costs.hpp"
#include "roster.hpp"

namespace idiophone::voices {

SoundMapVoices::SoundMapVoices(const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps,
                               const Audience& audience, int rate, const MapDetail& detail,
                               std::span<const score::BodyContact> contacts)
    : costs_(std::make_unique<MapCosts>(rate, detail.speed, audience.receivers())),
      audience_(audience),
      detail_(detail),
      channels_(audience.receivers()),
      rate_(rate),
      arrivals_(audience.has_head() ? 0 : channels_, Arrivals(longest_way * rate)) {
  const std::vector<HearingPoint> points = audience.is_fixed() ? std::vector<HearingPoint>{} : audience.points(0.0);
  std::vector<std::unique_ptr<MapBody>> bodies;
  for (const auto& one : prepared(maps)) {
    names_.push_back(one->map->body);
    bodies.push_back(std::make_unique<MapBody>(one, audience, points, rate, detail));
    bodies.back()->player().set_priority(1.0 - static_cast<double>(bodies.size()));
  }
  std::vector<std::unique_ptr<ContactGroup>> groups = contact_groups(bodies, contacts, channels_, rate);
  roster_ = std::make_unique<Roster>(std::move(bodies), std::move(groups), detail, channels_, rate);
  changes_.reserve(2 * most_changes);
}

SoundMapVoices::~SoundMapVoices() = default;

MapBody& SoundMapVoices::body(std::size_t number) const {
  return *roster_->bodies()[number];
}

bool SoundMapVoices::is_free(std::size_t number) const {
  return number >= roster_->bodies().size() || roster_->bodies()[number] == nullptr;
}

void SoundMapVoices::add(std::size_t number, const std::shared_ptr<const sound_maps::SoundMap>& map,
                         std::vector<HearingPoint> points) {
  require_no_head();
  const auto bodies = roster_->bodies();
  const auto same = std::ranges::find_if(bodies, [&](const auto& body) { return body && &body->map() == map.get(); });
  const auto known = same != bodies.end() ? (*same)->prepared() : std::make_shared<const PreparedMap>(map);
  auto joins = std::make_unique<MapBody>(known, audience_, std::move(points), rate_, detail_);
  joins->player().set_priority(-static_cast<double>(number));
  names_.resize(std::max(names_.size(), number + 1));
  names_[number] = map->body;
  roster_->join(number, std::move(joins));
}

void SoundMapVoices::remove(std::size_t body) {
  require_no_head();
  roster_->leave(body);
}

void SoundMapVoices::require_no_head() const {
  if (audience_.has_head()) {
    throw std::runtime_error("bodies that a head hears can't join or leave");
  }
}

std::optional<Vector3> SoundMapVoices::centre(std::size_t body) const {
  return this->body(body).map().centre;
}

void SoundMapVoices::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  if (this->body(body).player().touches_something()) {
    throw std::runtime_error("tune: " + names_[body] + " is in `contacts` of the score, so it can't be tuned");
  }
  if (tuning.tension != 1.0) {
    throw std::runtime_error("tune: only proxies have a tension; sound maps have size and friction");
  }
}

void SoundMapVoices::require_in_reach(const Vector3& place) const {
  for (const MapBody* body : roster_->present()) {
    body->require_in_reach(place);
  }
}

void SoundMapVoices::excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) {
  this->body(body).excite(excitation, sent);
}

void SoundMapVoices::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  this->body(body).tune(tuning, start);
}

void SoundMapVoices::touch(std::size_t body, const drivers::Touching& touch, std::int64_t start) {
  this->body(body).touch(touch, start);
}

void SoundMapVoices::lead(std::size_t body, const drivers::TouchLead& lead, std::int64_t start) {
  this->body(body).lead(lead, start);
}

void SoundMapVoices::set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) {
  if (detail.level || detail.most_active) {
    throw std::runtime_error("detail: only proxies have a level and most_active; the sound map of " + names_[body] +
                             " has a priority and a budget");
  }
  queued_.push_back({.start = start, .body = body, .detail = detail});
  attend();
}

void SoundMapVoices::set_budget(double budget, std::int64_t start) {
  score::Detail detail;
  detail.budget = budget;
  set_detail(0, detail, start);
}

double SoundMapVoices::cost_of_driven(std::size_t body) const {
  return costs_->of_driven(this->body(body).player().sound().groups(), true);
}

bool SoundMapVoices::is_heard(std::size_t body) const {
  return this->body(body).player().is_heard();
}

std::vector<MapChoice> SoundMapVoices::take_choices() {
  attend();
  return std::exchange(told_, {});
}

void SoundMapVoices::hear_at(const ListenerPlace& place) {
  for (MapBody* body : roster_->present()) {
    body->hear_at(place);
  }
}

void SoundMapVoices::hear_at(std::size_t body, const ListenerPlace& place) {
  this->body(body).hear_at(place);
}

void SoundMapVoices::attend() {
  roster_->attend();
  while (!queued_.empty() && incoming_.put(queued_.front())) {
    queued_.pop_front();
  }
  for (MapChoice choice; choices_.take(choice);) {
    told_.push_back(choice);
  }
}

VoiceReport SoundMapVoices::report() const {
  VoiceReport report;
  for (const MapBody* body : roster_->present()) {
    report.waits.add(body->player().waits());
    if (const double rotation = body->player().sound().largest_rotation();
        rotation > modal_bodies::largest_right_rotation) {
      report.doubts.push_back(fmt::format("body {}: {}. Hit less hard, or choose a thicker body", body->map().body,
                                          modal_bodies::too_large_rotation(rotation)));
    }
  }
  return report;
}

/// In pieces that no block divides otherwise. The sounds of all bodies are on their way before a piece is heard.
void SoundMapVoices::render(std::span<double> sound, std::int64_t clock) {
  constexpr auto longest = static_cast<std::int64_t>(resonators::ResonatorBank::most_samples);
  const std::int64_t begin = now_;
  while (!sound.empty()) {
    const auto left = static_cast<std::int64_t>(sound.size() / channels_);
    const auto samples = static_cast<std::size_t>(std::min(left, longest - now_ % longest));
    const std::span<double> piece = sound.first(samples * channels_);
    Lineup& lineup = roster_->lineup();
    if (now_ % MapChoice::interval == 0) {
      choose(lineup);
    }
    for (ContactGroup* group : lineup.groups) {
      group->render(piece, now_, clock + (now_ - begin) * 1'000'000'000 / rate_);
    }
    send(lineup, samples);
    for (std::size_t r = 0; r < arrivals_.size(); ++r) {
      arrivals_[r].take(now_, piece.subspan(r), channels_);
    }
    now_ += static_cast<std::int64_t>(samples);
    sound = sound.subspan(piece.size());
  }
}

void SoundMapVoices::choose(Lineup& lineup) {
  for (DetailChange change; changes_.size() < most_changes && incoming_.take(change);) {
    changes_.push_back(change);
  }
  std::erase_if(changes_, [&](const DetailChange& change) {
    if (change.start > now_ || change.body >= lineup.by_number.size()) {  // or a body joins later
      return false;
    }
    MapBody* body = lineup.by_number[change.body];
    if (change.detail.priority && body != nullptr) {
      body->player().set_priority(*change.detail.priority);
    }
    if (change.detail.budget) {
      lineup.choice->set_budget(*change.detail.budget);
    }
    return true;
  });
  if (lineup.choice->is_limited()) {
    MapChoice chosen = lineup.choice->choose(lineup.bodies, now_);
    choices_.put(chosen);
  }
}

/// Sample by sample, so that the numbers do not depend on how samples are divided into pieces.
void SoundMapVoices::send(Lineup& lineup, std::size_t samples) {
  lineup.sounding.clear();
  for (const MapBody* body : lineup.bodies) {
    if (body->player().sound().emits()) {
      lineup.sounding.push_back(body);
    }
  }
  for (std::size_t i = 0; i < samples && !lineup.sounding.empty(); ++i) {
    for (const MapBody* body : lineup.sounding) {
      for (std::size_t r = 0; r < arrivals_.size(); ++r) {
        const Emitted& emitted = body->player().sound().emitted(i, r);
        arrivals_[r].add(now_ + static_cast<std::int64_t>(i), emitted.pressure, emitted.delay);
      }
    }
  }
}

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

std::vector<std::shared_ptr<const sound_maps::SoundMap>> shared_maps(std::vector<sound_maps::SoundMap> maps) {
  std::vector<std::shared_ptr<const sound_maps::SoundMap>> shared;
  shared.reserve(maps.size());
  for (sound_maps::SoundMap& map : maps) {
    shared.push_back(std::make_shared<const sound_maps::SoundMap>(std::move(map)));
  }
  return shared;
}

double shortest_delay() {
  return Arrivals::nearest();
}

}  // namespace idiophone::voices

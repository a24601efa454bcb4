#include "idiophone/instruments/voices/sound_map_voices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "contact_group.hpp"
#include "map_body.hpp"
#include "mode_choice.hpp"

namespace idiophone::voices {

SoundMapVoices::SoundMapVoices(const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps,
                               const Audience& audience, int rate, const MapDetail& detail,
                               std::span<const score::BodyContact> contacts)
    : channels_(audience.receivers()),
      rate_(rate),
      arrivals_(audience.has_head() ? 0 : channels_, Arrivals(longest_way * rate)) {
  const std::vector<HearingPoint> points = audience.is_fixed() ? std::vector<HearingPoint>{} : audience.points(0.0);
  for (const auto& one : prepared(maps)) {
    names_.push_back(one->map->body);
    bodies_.push_back(std::make_unique<MapBody>(one, audience, points, rate, detail));
    bodies_.back()->player().set_priority(1.0 - static_cast<double>(bodies_.size()));
  }
  groups_ = contact_groups(bodies_, contacts, channels_, rate);
  choice_ = std::make_unique<ModeChoice>(detail, bodies_, channels_, rate);
  changes_.reserve(2 * most_changes);
  sounding_.reserve(bodies_.size());
}

SoundMapVoices::~SoundMapVoices() = default;

std::optional<Vector3> SoundMapVoices::centre(std::size_t body) const {
  return bodies_[body]->map().centre;
}

void SoundMapVoices::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  if (bodies_[body]->player().touches_something()) {
    throw std::runtime_error("tune: " + names_[body] + " is in `contacts` of the score, so it can't be tuned");
  }
  if (tuning.tension != 1.0) {
    throw std::runtime_error("tune: only proxies have a tension; sound maps have size and friction");
  }
}

void SoundMapVoices::require_in_reach(const Vector3& place) const {
  for (const auto& body : bodies_) {
    body->require_in_reach(place);
  }
}

void SoundMapVoices::excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) {
  bodies_[body]->excite(excitation, sent);
}

void SoundMapVoices::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  bodies_[body]->tune(tuning, start);
}

void SoundMapVoices::touch(std::size_t body, const drivers::Touching& touch, std::int64_t start) {
  bodies_[body]->touch(touch, start);
}

void SoundMapVoices::lead(std::size_t body, const drivers::TouchLead& lead, std::int64_t start) {
  bodies_[body]->lead(lead, start);
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
  return choice_->cost_of_driven(body);
}

bool SoundMapVoices::is_heard(std::size_t body) const {
  return bodies_[body]->player().is_heard();
}

std::vector<MapChoice> SoundMapVoices::take_choices() {
  attend();
  return std::exchange(told_, {});
}

void SoundMapVoices::hear_at(const ListenerPlace& place) {
  for (const auto& body : bodies_) {
    body->hear_at(place);
  }
}

void SoundMapVoices::hear_at(std::size_t body, const ListenerPlace& place) {
  bodies_[body]->hear_at(place);
}

void SoundMapVoices::attend() {
  for (const auto& body : bodies_) {
    body->attend();
  }
  while (!queued_.empty() && incoming_.put(queued_.front())) {
    queued_.pop_front();
  }
  for (MapChoice choice; choices_.take(choice);) {
    told_.push_back(choice);
  }
}

VoiceReport SoundMapVoices::report() const {
  Waits waits;
  for (const auto& body : bodies_) {
    waits.add(body->player().waits());
  }
  return {.waits = waits};
}

/// In pieces that no block divides otherwise. The sounds of all bodies are on their way before a piece is heard.
void SoundMapVoices::render(std::span<double> sound, std::int64_t clock) {
  constexpr auto longest = static_cast<std::int64_t>(resonators::ResonatorBank::most_samples);
  const std::int64_t begin = now_;
  while (!sound.empty()) {
    const auto left = static_cast<std::int64_t>(sound.size() / channels_);
    const auto samples = static_cast<std::size_t>(std::min(left, longest - now_ % longest));
    const std::span<double> piece = sound.first(samples * channels_);
    if (now_ % MapChoice::interval == 0) {
      choose();
    }
    for (const auto& group : groups_) {
      group->render(piece, now_, clock + (now_ - begin) * 1'000'000'000 / rate_);
    }
    send(samples);
    for (std::size_t r = 0; r < arrivals_.size(); ++r) {
      arrivals_[r].take(now_, piece.subspan(r), channels_);
    }
    now_ += static_cast<std::int64_t>(samples);
    sound = sound.subspan(piece.size());
  }
}

void SoundMapVoices::choose() {
  for (DetailChange change; changes_.size() < most_changes && incoming_.take(change);) {
    changes_.push_back(change);
  }
  std::erase_if(changes_, [&](const DetailChange& change) {
    if (change.start > now_) {
      return false;
    }
    if (change.detail.priority) {
      bodies_[change.body]->player().set_priority(*change.detail.priority);
    }
    if (change.detail.budget) {
      choice_->set_budget(*change.detail.budget);
    }
    return true;
  });
  if (choice_->is_limited()) {
    MapChoice chosen = choice_->choose(bodies_, now_);
    choices_.put(chosen);
  }
}

/// Sample by sample, so that the numbers do not depend on how samples are divided into pieces.
void SoundMapVoices::send(std::size_t samples) {
  sounding_.clear();
  for (const auto& body : bodies_) {
    if (body->player().sound().emits()) {
      sounding_.push_back(body.get());
    }
  }
  for (std::size_t i = 0; i < samples && !sounding_.empty(); ++i) {
    for (const MapBody* body : sounding_) {
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
  for (sound_maps::SoundMap& map : maps) {
    shared.push_back(std::make_shared<const sound_maps::SoundMap>(std::move(map)));
  }
  return shared;
}

double shortest_delay() {
  return Arrivals::nearest();
}

}  // namespace idiophone::voices

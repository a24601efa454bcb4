#include "idiophone/instruments/voices/proxy_voices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/place_text.hpp"
#include "idiophone/instruments/voices/map_detail.hpp"

namespace idiophone::voices {

namespace {

constexpr std::int64_t samples_to_a_move = 64;  // after which the engine is told where its listeners are
constexpr double nearest_point = 0.01;          // m: points that are nearer to a body are taken to be there

proxies::Tuning tuning_of(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  return {.body = body, .start = start, .tension = tuning.tension, .friction = tuning.friction, .size = tuning.size};
}

}  // namespace

proxies::Force proxy_force(std::size_t body, const resonators::PointForce& force) {
  proxies::Force found{.body = body, .start = force.start, .at = force.at, .direction = force.direction, .curve = {}};
  for (const resonators::ForcePiece& piece : force.force) {
    found.curve.push_back(piece.mean);
  }
  return found;
}

ProxyVoices::ProxyVoices(proxies::Engine engine, std::vector<ProxyBody> bodies, const Audience& audience,
                         const ProxyHearing& hearing)
    : engine_(std::move(engine)),
      bodies_(std::move(bodies)),
      channels_(audience.receivers()),
      hearing_(hearing),
      audience_(audience),
      points_(audience.points(0.0)),
      arrivals_(audience.has_head() ? 0 : points_.count(), Arrivals(longest_way * hearing.rate)) {
  for (const ProxyBody& body : bodies_) {
    roots_.push_back(names_.size());
    names_.push_back(body.name);
  }
  require_in_reach(middle_of(points_.goal()));
  for (std::size_t body = 0; audience.has_head() && body < names_.size(); ++body) {
    ears_.emplace_back(longest_way * hearing.rate, audience.head_responses(place(body, 0), points_.at(0, 0)));
  }
}

std::size_t ProxyVoices::add(proxies::BodyOptions options, ProxyBody body) {
  if (audience_.has_head()) {
    throw std::runtime_error("bodies that a head hears can't join");
  }
  const std::size_t number = engine_.add(std::move(options));
  const std::size_t count = std::max(bodies_.size(), number + 1);
  bodies_.resize(count);
  roots_.resize(count);
  names_.resize(count);
  names_[number] = body.name;
  roots_[number] = number;
  bodies_[number] = std::move(body);
  jump(number);
  return number;
}

/// As if the engine had been told in time.
void ProxyVoices::jump(std::size_t body) {
  const std::int64_t last_move = now_ - now_ % samples_to_a_move;
  move_listener(body, middle_of_points(last_move), last_move);
}

void ProxyVoices::require_in_reach(const Vector3& place) const {
  for (const ProxyBody& body : bodies_) {
    if ((place - body.centre).norm() > longest_way * hearing_.speed_of_sound) {
      throw std::runtime_error(fmt::format("{} is too far away from {} for a listener", to_text(place), body.name));
    }
  }
}

void ProxyVoices::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  engine_.require_tunable(tuning_of(body, tuning, 0));
}

void ProxyVoices::excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t /*sent*/) {
  for (const resonators::PointForce& force : excitation.forces) {
    engine_.add(proxy_force(body, force));
  }
}

void ProxyVoices::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  engine_.add(tuning_of(body, tuning, start));
}

void ProxyVoices::set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) {
  if (detail.level && *detail.level >= 0) {
    engine_.require_level(body, static_cast<std::size_t>(*detail.level));
  }
  const auto later = std::ranges::upper_bound(changes_, start, {}, &Change::start);
  changes_.insert(later, {.start = start, .body = body, .detail = detail});
}

void ProxyVoices::set_budget(double budget, std::int64_t start) {
  score::Detail detail;
  detail.budget = budget;
  set_detail(0, detail, start);
}

std::vector<Claim> ProxyVoices::claims() const {
  std::vector<Claim> claims;
  for (const proxies::Share& share : engine_.shares()) {
    claims.push_back({.priority = share.priority, .cost = share.cost / hearing_.speed});
  }
  return claims;
}

/// Proxies give way to sound maps of at least their priority.
void ProxyVoices::share_budget() {
  engine_.keep_limits();
  hearing_.shared->proxies.make(claims());
}

void ProxyVoices::make_due_changes() {
  for (; !changes_.empty() && changes_.front().start <= engine_.now(); changes_.pop_front()) {
    change(changes_.front().body, changes_.front().detail);
  }
}

void ProxyVoices::change(std::size_t body, const score::Detail& detail) {
  if (detail.level) {
    engine_.set_level(body, *detail.level < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(*detail.level)));
  }
  if (detail.priority) {
    engine_.set_priority(body, *detail.priority);
  }
  if (detail.budget || detail.most_active) {
    hearing_.budget = detail.budget.value_or(hearing_.budget);
    hearing_.most_active = detail.most_active ? static_cast<std::size_t>(*detail.most_active) : hearing_.most_active;
    engine_.set_limits(hearing_.budget * hearing_.speed, hearing_.most_active);
  }
}

void ProxyVoices::take_film(double frames_per_second) {
  film_.emplace(engine_, names_, frames_per_second, hearing_.rate);
}

void ProxyVoices::film_if_due() {
  if (film_ && film_->samples_until_frame(engine_.now()) == 0) {
    film_->add(engine_, roots_, [&](std::size_t body) { return pose(body, engine_.now()); });
  }
}

void ProxyVoices::hear_at(const ListenerPlace& place) {
  points_.go(place);
}

Eigen::Isometry3d ProxyVoices::pose(std::size_t body, std::int64_t sample) const {
  const drivers::BodyTrack& track = bodies_[body].track;
  return track ? track(static_cast<double>(sample) / hearing_.rate) : Eigen::Isometry3d::Identity();
}

Vector3 ProxyVoices::place(std::size_t body, std::int64_t sample) const {
  return bodies_[body].track ? Vector3(pose(body, sample) * bodies_[body].centre) : bodies_[body].centre;
}

Vector3 ProxyVoices::middle_of_points(std::int64_t sample) const {
  std::vector<HearingPoint> points;
  for (std::size_t point = 0; point < points_.count(); ++point) {
    points.push_back(points_.at(point, sample));
  }
  return middle_of(points);
}

/// Tells the engine where the middle of the points is, in the coordinates of a body.
void ProxyVoices::move_listener(std::size_t body, const Vector3& middle, std::int64_t sample) {
  const Eigen::Isometry3d to_body = pose(body, sample).inverse();
  engine_.move_listener(body, to_body * middle, to_body.linear() * audience_.look());
}

void ProxyVoices::move_listeners() {
  const Vector3 middle = middle_of_points(now_);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    move_listener(body, middle, now_);
  }
}

/// To where the bodies are now.
void ProxyVoices::turn_ears() {
  for (std::size_t body = 0; body < ears_.size(); ++body) {
    if (!ears_[body].turns()) {
      ears_[body].turn_to(audience_.head_responses(place(body, now_), points_.at(0, now_)));
    }
  }
}

void ProxyVoices::advance(std::size_t samples) {
  add_landings(samples);
  each_.resize(std::max<std::size_t>(1, bodies_.size()) * samples);
  engine_.render_each(each_);
}

/// Sends the sounds of all bodies on their ways.
void ProxyVoices::emit(std::size_t samples) {
  for (std::size_t body = 0; body < each_.size() / samples; ++body) {
    for (std::size_t i = 0; i < samples; ++i) {
      const double value = each_[body * samples + i];
      if (value == 0.0) {
        continue;
      }
      const std::int64_t sample = now_ + static_cast<std::int64_t>(i);
      const Vector3 from = place(body, sample);
      for (std::size_t point = 0; point < points_.count(); ++point) {
        const auto [distance, gain] = voices::hearing(points_.at(point, sample), from, nearest_point);
        const double delay = distance / hearing_.speed_of_sound * hearing_.rate;
        ears_.empty() ? arrivals_[point].add(sample, gain * value, delay)
                      : ears_[roots_[body]].add(sample, gain * value, delay);
      }
    }
  }
}

void ProxyVoices::take(std::span<double> sound) {
  for (std::size_t point = 0; point < points_.count(); ++point) {
    arrivals_[point].take(now_, sound.subspan(point), channels_);
  }
}

void ProxyVoices::take_with_ears(std::span<double> sound) {
  for (BodyEars& body : ears_) {
    body.hear(now_, sound);
  }
}

/// The deviations, in all channels.
void ProxyVoices::add_as_it_is(std::span<double> sound) {
  const std::size_t samples = sound.size() / channels_;
  for (std::size_t i = 0; i < each_.size(); ++i) {
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      sound[i % samples * channels_ + channel] += each_[i];
    }
  }
}

void ProxyVoices::render(std::span<double> sound, std::int64_t /*clock*/) {
  film_if_due();
  if (now_ == 0 && engine_.now() == 0) {  // what comes late comes early enough
    advance(static_cast<std::size_t>(engine_.delay()));
  }
  while (!sound.empty()) {
    film_if_due();
    points_.begin_due(now_);
    if (hearing_.shared && now_ % MapChoice::interval == 0) {
      share_budget();
    }
    if (now_ % samples_to_a_move == 0) {
      move_listeners();
      turn_ears();
    }
    const std::int64_t until_move = samples_to_a_move - now_ % samples_to_a_move;
    const auto left = static_cast<std::int64_t>(sound.size() / channels_);
    auto samples = static_cast<std::size_t>(points_.samples_without_change(now_, std::min(left, until_move)));
    make_due_changes();
    if (!changes_.empty()) {
      samples = std::min(samples, static_cast<std::size_t>(changes_.front().start - engine_.now()));
    }
    if (film_) {
      const std::int64_t until_frame = film_->samples_until_frame(engine_.now());
      samples = std::min(samples, static_cast<std::size_t>(std::max<std::int64_t>(1, until_frame)));
    }
    advance(samples);
    const std::span<double> part = sound.first(samples * channels_);
    if (hearing_.sound == proxies::Sound::pressure) {
      emit(samples);
      ears_.empty() ? take(part) : take_with_ears(part);
    } else {
      add_as_it_is(part);
    }
    take_fractures();
    now_ += static_cast<std::int64_t>(samples);
    sound = sound.subspan(samples * channels_);
  }
}

}  // namespace idiophone::voices

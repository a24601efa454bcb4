#include "proxy_voice.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace idiophone::proxies {

namespace {

constexpr double fade_duration = 0.002;    // s
constexpr double turn_duration = 0.01;     // s, from what is heard in one direction to what is heard in another
constexpr double nearest_listener = 0.01;  // m: those that are nearer are taken to be there

double distance_of(const BodyOptions& body) {
  return std::max(nearest_listener, (body.listener - body.levels.front()->inertia().centre).norm());
}

Damping damping_of(const Lattice& lattice, const Tuning& tuning) {
  return {.mass = tuning.friction * lattice.damping().mass, .stiffness = tuning.friction * lattice.damping().stiffness};
}

}  // namespace

Voice::Voice(BodyOptions body, const EngineOptions& options, std::size_t number)
    : body_(std::move(body)), options_(options), up_sampler_(options.largest_divisor), number_(number) {
  make_proxies();
}

void Voice::make_proxies() {
  std::vector<Proxy> made;
  for (const auto& lattice : body_.levels) {
    made.emplace_back(lattice, ProxyOptions{.integrator = options_.integrator,
                                            .rate = static_cast<double>(options_.rate),
                                            .significant_distance = options_.significant_distance});
  }
  proxies_ = std::move(made);
  details_.clear();
  for (std::size_t level = 0; level < body_.levels.size(); ++level) {
    for (int divisor = 1; divisor <= options_.largest_divisor; divisor *= 2) {
      details_.push_back({.level = level, .divisor = divisor});
    }
  }
  chosen_ = 0;
  find_details();
}

double Voice::smallest_cost() const {
  const auto last =
      std::ranges::find_if(details_.rbegin(), details_.rend(), [&](const Detail& detail) { return may_have(detail); });
  return last->cost;
}

/// Their costs, and their order.
void Voice::find_details() {
  const Detail before = detail();
  for (Detail& each : details_) {
    Proxy& of_level = proxies_[each.level];
    of_level.set_rate(static_cast<double>(options_.rate) / each.divisor);
    each.cost = of_level.springs_per_second();
  }
  std::ranges::sort(details_, [](const Detail& a, const Detail& b) {
    return std::tuple(-a.cost, a.level, a.divisor) < std::tuple(-b.cost, b.level, b.divisor);
  });
  const auto same = std::ranges::find_if(
      details_, [&](const Detail& each) { return each.level == before.level && each.divisor == before.divisor; });
  chosen_ = static_cast<std::size_t>(same - details_.begin());
  proxy().set_rate(static_cast<double>(options_.rate) / detail().divisor);
}

void Voice::require_tunable(const Tuning& tuning) const {
  for (const double factor : {tuning.tension, tuning.friction, tuning.size}) {
    if (!std::isfinite(factor) || !(factor >= 0.0)) {
      throw std::invalid_argument("tension, friction and size are finite and not negative");
    }
  }
  if (!(tuning.tension > 0.0) || !(tuning.size > 0.0)) {
    throw std::invalid_argument("tension and size must be above 0");
  }
  for (const auto& lattice : body_.levels) {
    (void)stable_steps(options_.integrator,
                       std::sqrt(tuning.tension) / tuning.size * lattice->largest_angular_frequency(),
                       damping_of(*lattice, tuning), static_cast<double>(options_.largest_divisor) / options_.rate);
  }
}

/// Lengths that are s times as large make masses s^3 and springs s times as large, and surfaces s^2 times. So the
/// springs change by s/s^3, and the sound for a force by s^2/s^3.
void Voice::tune(const Tuning& tuning) {
  for (Proxy& each : proxies_) {
    each.tune(tuning.tension / (tuning.size * tuning.size), damping_of(each.lattice(), tuning));
  }
  mobility_ = 1.0 / tuning.size;
  tuning_ = tuning;
  find_details();
}

double Voice::strength_of(const Force& force) const {
  const double impulse = std::accumulate(force.curve.begin(), force.curve.end(), 0.0) / options_.rate;
  return std::abs(impulse) * force.direction.norm() / body_.levels.front()->inertia().mass;
}

double Voice::priority_with(double strength) const {
  const double distance = distance_of(body_);
  const bool is_behind = direction_to_listener().dot(front_) > 0.0;
  if (options_.priority_of) {
    return options_.priority_of(
        {.body = number_, .distance = distance, .strength = strength, .is_behind = is_behind, .own = body_.priority});
  }
  const double factor = is_behind ? options_.behind : 1.0;
  switch (options_.priority) {
    case Priority::distance:
      return factor / distance;
    case Priority::loudness:
    case Priority::audibility:
      return factor * strength / distance;
    case Priority::fixed:
      return body_.priority < 0.0 ? body_.priority / factor : body_.priority * factor;
  }
  return 0.0;
}

double Voice::loudness() const {
  return options_.sound == Sound::deviation ? 1.0 : 1.0 / distance_of(body_);
}

Vector3 Voice::direction_to_listener() const {
  const Vector3 direction = body_.listener - body_.levels.front()->inertia().centre;
  return direction.norm() > 0.0 ? direction : Vector3::UnitZ();
}

void Voice::move_listener(const Vector3& listener, const Vector3& front) {
  body_.listener = listener;
  front_ = front;
  if (sounds_ && turn_ < 0) {
    begin_turn();
  }
}

/// Crosses over to what is heard of the triangles that face the listener now, so that none begins with a click.
void Voice::begin_turn() {
  if (options_.sound == Sound::pressure && proxy().turn_to(direction_to_listener())) {
    next_volume_velocity_ = proxy().next_facing_volume_velocity();
    turn_ = 0;
  }
}

void Voice::begin(std::size_t chosen, std::int64_t sample) {
  chosen_ = chosen;
  proxy().set_rate(static_cast<double>(options_.rate) / detail().divisor);
  proxy().face(direction_to_listener());
  up_sampler_.restart(detail().divisor);
  origin_ = sample;
  quiet_ = 0;
  volume_velocity_ = 0.0;
  turn_ = -1;
  strength_ = 0.0;
  gain_ = 1.0;
  fades_ = false;
  sounds_ = true;
}

void Voice::add(Force force) {
  const Contact contact = proxy().lattice().contact_at(force.at);
  strength_ = std::max(strength_, strength_of(force));
  acting_.push_back({.force = std::move(force), .contact = contact});
}

/// The mean over the coming interval of what has not acted yet.
void Voice::take_forces(std::int64_t sample) {
  point_forces_.clear();
  const int divisor = detail().divisor;
  for (ActingForce& acting : acting_) {
    const std::vector<double>& curve = acting.force.curve;
    const auto end = static_cast<std::size_t>(
        std::clamp<std::int64_t>(sample + divisor - acting.force.start, 0, static_cast<std::int64_t>(curve.size())));
    double sum = 0.0;
    for (; acting.taken < end; ++acting.taken) {
      sum += curve[acting.taken];
    }
    point_forces_.push_back({.contact = acting.contact, .force = mobility_ * sum / divisor * acting.force.direction});
  }
  std::erase_if(acting_, [](const ActingForce& acting) { return acting.taken == acting.force.curve.size(); });
}

double Voice::next_value() {
  if (options_.sound == Sound::deviation) {
    return proxy().deviation();
  }
  const double before = std::exchange(volume_velocity_, proxy().facing_volume_velocity());
  double change = volume_velocity_ - before;
  if (turn_ >= 0) {
    const double next_before = std::exchange(next_volume_velocity_, proxy().next_facing_volume_velocity());
    const double share = static_cast<double>(turn_) / (turn_duration * options_.rate);
    change += std::min(share, 1.0) * (next_volume_velocity_ - next_before - change);
    turn_ += detail().divisor;
    if (share >= 1.0) {
      proxy().end_turn();
      volume_velocity_ = next_volume_velocity_;
      turn_ = -1;
      begin_turn();  // the listener may have moved meanwhile
    }
  }
  return options_.air_density / (2.0 * std::numbers::pi) * change * options_.rate / detail().divisor;
}

Fragment Voice::fragment() const {
  const Proxy& sounding = proxies_[detail().level];
  Fragment fragment{.lattice = body_.levels[detail().level], .displacement = {}, .velocity = {}};
  for (std::size_t mass = 0; mass < fragment.lattice->masses().size(); ++mass) {
    fragment.displacement.push_back(sounding.displacement(static_cast<Index>(mass)));
    fragment.velocity.push_back(sounding.velocity(static_cast<Index>(mass)));
  }
  return fragment;
}

void Voice::go_on_as(const Fragment& fragment) {
  const int divisor = detail().divisor;
  std::vector<std::shared_ptr<const Lattice>> before = std::exchange(body_.levels, {fragment.lattice});
  try {
    make_proxies();
    tune(tuning_);
  } catch (const std::invalid_argument&) {
    body_.levels = std::move(before);
    throw;
  }
  level_.reset();
  chosen_ = static_cast<std::size_t>(std::ranges::find(details_, divisor, &Detail::divisor) - details_.begin());
  proxy().set_rate(static_cast<double>(options_.rate) / divisor);
  proxy().set_state(fragment.displacement, fragment.velocity);
  proxy().face(direction_to_listener());
  volume_velocity_ = proxy().facing_volume_velocity();
  turn_ = -1;
  for (ActingForce& acting : acting_) {
    acting.contact = proxy().lattice().contact_at(acting.force.at);
  }
}

std::vector<Force> Voice::stop() {
  std::vector<Force> left;
  for (ActingForce& acting : acting_) {
    Force& force = acting.force;
    force.curve.erase(force.curve.begin(), force.curve.begin() + static_cast<std::ptrdiff_t>(acting.taken));
    force.start += static_cast<std::int64_t>(acting.taken);
    left.push_back(std::move(force));
  }
  end();
  return left;
}

void Voice::end() {
  proxy().stop();
  acting_.clear();
  sounds_ = false;
  fades_ = false;
}

std::size_t Voice::render(std::int64_t first, std::span<double> sound) {
  const int divisor = detail().divisor;
  const double fade_step = 1.0 / (fade_duration * options_.rate);
  const std::int64_t silence = UpSampler::delay(options_.largest_divisor) + std::int64_t{4} * divisor;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const std::int64_t sample = first + static_cast<std::int64_t>(i);
    const int place = static_cast<int>((sample - origin_) % divisor);
    if (place == 0) {
      take_forces(sample);
      proxy().advance(point_forces_);
      up_sampler_.add(next_value());
      quiet_ = proxy().is_stable() && acting_.empty() ? quiet_ + divisor : 0;
    }
    sound[i] += gain_ * up_sampler_.take(place);
    gain_ = std::clamp(gain_ + (fades_ ? -fade_step : fade_step), 0.0, 1.0);
    if (gain_ == 0.0 || quiet_ > silence) {
      end();
      return i + 1;
    }
  }
  return sound.size();
}

}  // namespace idiophone::proxies

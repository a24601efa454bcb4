#include "tree_voice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/timbre/nodes/random.hpp"

namespace idiophone::timbre {

namespace {

constexpr std::size_t most_instances = 8;   // that sound at once; the oldest one is faded out for another
constexpr std::size_t block = 64;           // audio samples
constexpr double fade_duration = 0.002;     // s
constexpr double longest_silence = 5.0;     // s, after which an instance is over
constexpr double inaudible = 1e-9;          // Pa
constexpr double nearest_listener = 0.1;    // m: those that are nearer are taken to be there
constexpr double speed_of_sound = 343.0;    // m/s
constexpr std::int64_t head_change = 1024;  // audio samples, from one direction of the head to the next

}  // namespace

TreeVoice::TreeVoice(Tree tree, std::string name, voices::Audience audience, std::uint64_t seed, int rate)
    : tree_(std::move(tree)),
      bodies_({std::move(name)}),
      audience_(std::move(audience)),
      seed_(seed),
      rate_(rate),
      points_(audience_.points(0.0)),
      arrivals_(points_.count(), voices::Arrivals(voices::longest_way * rate)),
      sound_(block),
      plain_(block) {
  static_cast<void>(Graph(tree_, bindings_of({.force = 1.0, .impulse = 1.0, .speed = 1.0}), {.rate = rate}));
  if (audience_.has_head()) {
    head_.emplace(audience_.head_responses(last_at_, points_.goal().front()));
  }
}

bool TreeVoice::has_parameter(const std::string& name) const {
  return std::ranges::find(tree_.parameters, name, &Parameter::name) != tree_.parameters.end();
}

Bindings TreeVoice::bindings_of(const drivers::Strength& strength) const {
  Bindings bindings;
  for (const auto& [name, value] : {std::pair("force", strength.force), std::pair("impulse", strength.impulse),
                                    std::pair("speed", strength.speed), std::pair("size", tuning_.size),
                                    std::pair("friction", tuning_.friction), std::pair("tension", tuning_.tension)}) {
    if (has_parameter(name)) {
      bindings[name] = Binding{.value = value, .where = {}};
    }
  }
  return bindings;
}

void TreeVoice::require_tunable(std::size_t /*body*/, const score::Tuning& tuning) const {
  for (const auto& [name, value] :
       {std::pair("size", tuning.size), std::pair("friction", tuning.friction), std::pair("tension", tuning.tension)}) {
    if (value != 1.0 && !has_parameter(name)) {
      throw std::runtime_error(fmt::format("tune: the tree {} has no parameter '{}'", bodies_.front(), name));
    }
  }
}

void TreeVoice::ask(Request request) {
  const auto later = std::ranges::upper_bound(requests_, request.start, {}, &Request::start);
  requests_.insert(later, std::move(request));
}

void TreeVoice::excite(std::size_t /*body*/, const drivers::Excitation& excitation, std::int64_t /*sent*/) {
  if (excitation.begins) {
    ask({.start = excitation.forces.front().start,
         .strength = excitation.strength,
         .at = excitation.place.value_or(excitation.forces.front().at),
         .tuning = {}});
  }
}

void TreeVoice::tune(std::size_t /*body*/, const score::Tuning& tuning, std::int64_t start) {
  ask({.start = start, .strength = {}, .tuning = tuning});
}

void TreeVoice::hear_at(const voices::ListenerPlace& place) {
  if (points_.count() > 0) {
    points_.go(place);
  }
}

void TreeVoice::start(const Request& request) {
  const auto sounding = std::ranges::count(instances_, false, &Instance::fades);
  if (static_cast<std::size_t>(sounding) >= most_instances) {
    std::ranges::find(instances_, false, &Instance::fades)->fades = true;
  }
  const double time = static_cast<double>(now_) / rate_;
  instances_.push_back(
      {.graph = Graph(tree_, bindings_of(*request.strength),
                      {.rate = rate_, .start = time, .body_seed = seed_, .start_seed = joined_seed(seed_, starts_++)}),
       .at = request.at});
  last_at_ = request.at;
  head_target_ = last_at_;
}

void TreeVoice::start_due() {
  for (; !requests_.empty() && requests_.front().start <= now_; requests_.pop_front()) {
    if (requests_.front().strength) {
      start(requests_.front());
    } else {
      tuning_ = requests_.front().tuning;
    }
  }
  if (points_.begin_due(now_)) {
    head_target_ = last_at_;
  }
}

/// Begins the change to the head's next responses, once the last one is over.
void TreeVoice::turn_head() {
  if (head_ && head_left_ == 0 && head_target_) {
    head_->begin(audience_.head_responses(*head_target_, points_.goal().front()));
    head_target_.reset();
    head_left_ = head_change;
  }
}

void TreeVoice::send(const Instance& instance, std::size_t count) {
  for (std::size_t r = 0; r < arrivals_.size(); ++r) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t sample = now_ + static_cast<std::int64_t>(i);
      const auto [distance, gain] = voices::hearing(points_.at(r, sample), instance.at, nearest_listener);
      arrivals_[r].add(sample, gain * sound_[i], distance / speed_of_sound * rate_);
    }
  }
}

void TreeVoice::emit(std::size_t count) {
  std::fill_n(plain_.begin(), count, 0.0);
  const double fade_step = 1.0 / (fade_duration * rate_);
  for (Instance& instance : instances_) {
    instance.graph.render(std::span(sound_).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      instance.gain = instance.fades ? std::max(0.0, instance.gain - fade_step) : 1.0;
      sound_[i] *= instance.gain;
      plain_[i] += sound_[i];
      instance.quiet = std::abs(sound_[i]) > inaudible ? 0 : instance.quiet + 1;
    }
    send(instance, count);
  }
  const auto silence = static_cast<std::int64_t>(longest_silence * rate_);
  std::erase_if(instances_, [&](const Instance& instance) {
    return instance.graph.has_ended() || instance.quiet > silence || (instance.fades && instance.gain == 0.0);
  });
}

void TreeVoice::take(std::span<double> sound) {
  const std::size_t channels = audience_.receivers();
  if (head_) {
    take_with_head(sound);
    return;
  }
  for (std::size_t r = 0; r < arrivals_.size(); ++r) {
    arrivals_[r].take(now_, sound.subspan(r), channels);
  }
  for (std::size_t i = 0; arrivals_.empty() && i < sound.size(); ++i) {
    sound[i] += plain_[i / channels];
  }
}

void TreeVoice::take_with_head(std::span<double> sound) {
  const std::span<double> arrived = std::span(plain_).first(sound.size() / 2);
  std::ranges::fill(arrived, 0.0);
  arrivals_.front().take(now_, arrived);
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    const double share = head_left_ > 0 ? 1.0 - static_cast<double>(head_left_) / head_change : 0.0;
    const auto [left, right] = head_->hear(arrived[i], share);
    sound[2 * i] += left;
    sound[2 * i + 1] += right;
    if (head_left_ > 0 && --head_left_ == 0) {
      head_->end();
    }
  }
}

void TreeVoice::render(std::span<double> sound, std::int64_t /*clock*/) {
  const std::size_t channels = audience_.receivers();
  while (!sound.empty()) {
    start_due();
    turn_head();
    auto count = std::min<std::int64_t>(block, static_cast<std::int64_t>(sound.size() / channels));
    count = requests_.empty() ? count : std::min(count, requests_.front().start - now_);
    count = points_.samples_without_change(now_, count);
    emit(static_cast<std::size_t>(count));
    take(sound.first(static_cast<std::size_t>(count) * channels));
    sound = sound.subspan(static_cast<std::size_t>(count) * channels);
    now_ += count;
  }
}

}  // namespace idiophone::timbre

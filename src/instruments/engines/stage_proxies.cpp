#include "stage_proxies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/instruments/touching/vectors.hpp"
#include "idiophone/instruments/voices/map_detail.hpp"
#include "moving_body.hpp"
#include "stage_checks.hpp"
#include "stage_ears.hpp"

namespace idiophone::engines {

namespace {

constexpr std::int64_t interval = voices::MapChoice::interval;  // samples of the voices that begin at a multiple of it
constexpr double least_budget = 1.0;                            // springs per second

/// Does something that proxies may refuse. @throws std::runtime_error when they do
template <class Action>
auto accepted(const Action& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
}

Eigen::Isometry3d isometry_of(const Pose& pose) {
  const auto& [x, y, z, w] = pose.turn;
  return Eigen::Translation3d(touching::vector_of(pose.position)) * Eigen::Quaterniond(w, x, y, z).normalized();
}

}  // namespace

StageProxies::StageProxies(std::vector<Vector3> ears, StageOptions options, double budget,
                           std::shared_ptr<voices::SharedBudget> shared)
    : options_(std::move(options)), budget_(budget), shared_(std::move(shared)), ears_(std::move(ears)) {}

/// Their samples begin at a multiple of the interval of the stage's, so that whoever joins sounds as if it had been
/// there from the start.
void StageProxies::begin(std::int64_t sample) {
  const double speed = options_.speed * voices::usual_speed;
  proxies::EngineOptions engine{.rate = options_.rate,
                                .air_density = options_.air_density,
                                .priority = proxies::Priority::audibility,
                                .most_active = options_.most_proxies,
                                .budget = std::max(least_budget, budget_ * speed)};
  if (shared_) {
    engine.others = [shared = shared_, speed](double priority) { return speed * shared->maps.at_least(priority); };
  }
  voices_.emplace(proxies::Engine(engine), std::vector<voices::ProxyBody>{}, audience_at(ears_),
                  voices::ProxyHearing{.speed_of_sound = options_.air_speed,
                                       .rate = options_.rate,
                                       .budget = engine.budget / speed,
                                       .speed = speed,
                                       .most_active = options_.most_proxies,
                                       .shared = shared_});
  const double most = options_.latency + most_ahead + longest_step;  // s, that can be ready
  ready_ = std::make_unique<ReadySound>(sample, ears_.size(), static_cast<std::size_t>(std::ceil(most * options_.rate)),
                                        options_.rate);
  origin_ = sample - sample % interval;
  block_.assign(static_cast<std::size_t>(sample % interval) * ears_.size(), 0.0);
  voices_->render(block_, 0);
  computed_ = sample % interval;
  ears_moved_ = false;
  played_.store(ready_.get(), std::memory_order_release);
}

void StageProxies::add(std::size_t number, const proxies::StoredBody& proxy, std::int64_t sample) {
  if (!voices_) {
    begin(sample);
  }
  auto motion = std::make_shared<ProxyMotion>();
  const auto track = [motion, rate = options_.rate](double time) { return motion->at(std::llround(time * rate)); };
  const std::size_t voice = accepted([&] {
    return voices_->add({.name = proxy.name, .levels = proxy.levels},
                        {.name = proxy.name, .centre = proxy.levels.front()->body_inertia().centre, .track = track});
  });
  bodies_.resize(std::max(bodies_.size(), number + 1));
  bodies_[number] = {.voice = voice, .motion = std::move(motion)};
}

void StageProxies::remove(std::size_t number) {
  voices_->remove(bodies_[number].voice);
  bodies_[number] = {};
}

void StageProxies::place(std::size_t number, const Pose& pose) {
  bodies_[number].goal = isometry_of(pose);
}

void StageProxies::listen(std::vector<Vector3> ears) {
  ears_moved_ = ears_moved_ || ears != ears_;
  ears_ = std::move(ears);
}

void StageProxies::require_tunable(std::size_t number, const score::Tuning& tuning) const {
  accepted([&] { voices_->require_tunable(bodies_[number].voice, tuning); });
}

void StageProxies::tune(std::size_t number, const score::Tuning& tuning, std::int64_t start) {
  voices_->tune(bodies_[number].voice, tuning, start - origin());
}

/// A body that does not sound is there at once.
void StageProxies::move(Body& body, std::int64_t start, std::int64_t length) {
  if (voices_->sounds(body.voice)) {
    body.motion->go(*body.goal, start, length);
  } else {
    body.motion->jump(*body.goal);
    voices_->jump(body.voice);
  }
  body.to_body = body.goal->inverse();
  body.goal.reset();
}

void StageProxies::send(std::span<const touching::ContactForce> forces, std::int64_t start, std::int64_t length) {
  if (!voices_) {
    return;
  }
  const std::int64_t first = origin(), duration = std::max<std::int64_t>(1, length);
  if (std::exchange(ears_moved_, false)) {
    voices_->hear_at({.start = start - first, .length = duration, .points = points_at(ears_)});
  }
  for (Body& body : bodies_) {
    if (body.goal) {
      move(body, start - first, duration);
    }
  }
  for (const touching::ContactForce& force : forces) {
    for (std::size_t side = 0; side < 2; ++side) {
      const auto number = static_cast<std::size_t>(force.bodies[side]);
      if (force.bodies[side] != ContactEvent::nobody && has(number)) {
        resonators::PointForce own = in_body(bodies_[number].to_body, force.force);
        own.direction *= side == 0 ? 1.0 : -1.0;
        own.start -= first;
        voices_->excite(bodies_[number].voice, {.forces = {std::move(own)}, .strength = {}}, 0);
      }
    }
  }
}

void StageProxies::compute_until(std::int64_t sample) {
  if (!voices_) {
    return;
  }
  for (std::int64_t left = std::min(sample - origin() - computed_, ready_->room()); left > 0;) {
    const std::int64_t samples = std::min(left, interval);
    block_.assign(static_cast<std::size_t>(samples) * ears_.size(), 0.0);
    voices_->render(block_, 0);
    ready_->put(block_);
    computed_ += samples;
    left -= samples;
  }
  for (const proxies::Choice& choice : voices_->take_choices()) {
    left_out_ += choice.kind == proxies::Choice::Kind::refuse ? 1 : 0;
  }
}

void StageProxies::note(StageReport& report) const {
  report.left_out += left_out_;
  report.proxies = 0;
  report.proxy_cost = 0.0;
  if (voices_) {
    for (const voices::Claim& claim : voices_->claims()) {
      ++report.proxies;
      report.proxy_cost += claim.cost;
    }
    report.gaps = ready_->gaps();
  }
}

void StageProxies::render(std::int64_t sample, std::span<double> sound) {
  if (ReadySound* ready = played_.load(std::memory_order_acquire)) {
    ready->take(sample, sound);
  }
}

}  // namespace idiophone::engines

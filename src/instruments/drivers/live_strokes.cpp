#include "idiophone/instruments/drivers/live_strokes.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <stdexcept>
#include <utility>

namespace idiophone::drivers {

namespace {

constexpr auto block = static_cast<std::int64_t>(resonators::RunningStroke::block);

void require_between(const char* what, double value, double most, const char* unit) {
  if (!(value >= 0.0 && value <= most)) {
    throw std::runtime_error(fmt::format("the {} has to be from 0 to {} {}, not {}", what, most, unit, value));
  }
}

}  // namespace

void LiveStrokes::begin(const std::string& name, std::size_t body, const score::Stroke& stroke, std::int64_t now) {
  if (has(name)) {
    throw std::runtime_error(fmt::format("the stroke '{}' goes on already; end it first", name));
  }
  if (running_.size() + ending_.size() == most) {
    throw std::runtime_error(fmt::format("{} strokes go on already; no more are possible", most));
  }
  running_.emplace(name, Running{.body = body,
                                 .stroke = resonators::RunningStroke(stroke, seed_, rate_),
                                 .strength = {.force = stroke.load, .speed = stroke.speed},
                                 .next = now + lead_ + block,
                                 .heard = now});
}

void LiveStrokes::change(const std::string& name, double speed, double load) {
  constexpr double fastest = 1e3, heaviest = 1e6;
  Running& stroke = find(name);
  require_between("speed", speed, fastest, "m/s");
  require_between("load", load, heaviest, "N");
  stroke.stroke.change(speed, load);
  stroke.heard = now_;
}

void LiveStrokes::end(const std::string& name) {
  Running& stroke = find(name);
  stroke.stroke.end();
  ending_.push_back(std::move(stroke));
  running_.erase(name);
}

bool LiveStrokes::has(const std::string& name) const {
  return running_.contains(name);
}

LiveStrokes::Running& LiveStrokes::find(const std::string& name) {
  const auto found = running_.find(name);
  if (found == running_.end()) {
    throw std::runtime_error(fmt::format("there is no stroke '{}'; begin it first", name));
  }
  return found->second;
}

void LiveStrokes::end_forgotten() {
  std::vector<std::string> forgotten;
  for (const auto& [name, running] : running_) {
    if (patience_ && static_cast<double>(now_ - running.heard) > *patience_ * rate_) {
      forgotten.push_back(name);
    }
  }
  for (const std::string& name : forgotten) {
    spdlog::warn("the stroke '{}' ends: nothing was heard of it for {} s", name, *patience_);
    end(name);
  }
}

/// Blocks are known one block before they sound.
void LiveStrokes::ask(std::int64_t now, std::vector<Event>& events) {
  now_ = now;
  end_forgotten();
  const auto go_on = [&](Running& running) {
    for (; running.next < now + lead_ + 2 * block && !running.stroke.is_over(); running.next += block) {
      events.push_back({.start = running.next,
                        .body = running.body,
                        .action = Excitation{.forces = running.stroke.next(running.next),
                                             .strength = running.strength,
                                             .begins = std::exchange(running.begins, false)}});
    }
  };
  for (auto& [name, running] : running_) {
    go_on(running);
  }
  for (Running& running : ending_) {
    go_on(running);
  }
  std::erase_if(ending_, [](const Running& running) { return running.stroke.is_over(); });
}

}  // namespace idiophone::drivers

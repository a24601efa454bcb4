#include "idiophone/instruments/drivers/live_strokes.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "blow_of_note.hpp"

namespace idiophone::drivers {

namespace {

constexpr auto block = static_cast<std::int64_t>(resonators::RunningStroke::block);

void require_between(const char* what, double value, double least, double most, const char* unit) {
  if (!(value >= least && value <= most)) {
    throw std::runtime_error(fmt::format("the {} has to be from {} to {} {}, not {}", what, least, most, unit, value));
  }
}

}  // namespace

void LiveStrokes::require_room_for(const std::string& name) const {
  if (has(name)) {
    throw std::runtime_error(fmt::format("the stroke '{}' goes on already; end it first", name));
  }
  if (running_.size() + ending_.size() == most) {
    throw std::runtime_error(fmt::format("{} strokes go on already; no more are possible", most));
  }
}

void LiveStrokes::begin(const std::string& name, std::size_t body, const score::Stroke& stroke, std::int64_t now) {
  require_room_for(name);
  Stroke begun{.forces = resonators::RunningStroke(stroke, seed_, rate_),
               .strength = {.force = stroke.load, .speed = stroke.speed},
               .next = now + lead_ + block};
  running_.emplace(name, Running{.body = body, .contact = std::move(begun), .heard = now});
}

void LiveStrokes::begin(const std::string& name, std::size_t body, const score::Bow& bow, std::int64_t now) {
  static std::atomic<std::int64_t> begun = 0;  // bows of all players
  require_room_for(name);
  const std::int64_t number = ++begun;
  score::Bow endless = bow;
  endless.duration = std::numeric_limits<double>::infinity();
  of_bows_.push_back({.start = now,
                      .body = body,
                      .action = Touching{.number = number, .contact = endless},
                      .sent = steady_clock()});  // so that what can't be bowed is a warning
  running_.emplace(name, Running{.body = body, .contact = TouchLead{.number = number}, .heard = now});
}

void LiveStrokes::change(const std::string& name, double speed, double load) {
  constexpr double fastest = 1e3, heaviest = 1e6;
  Running& running = find(name);
  auto* stroke = std::get_if<Stroke>(&running.contact);
  require_between("speed", speed, stroke != nullptr ? 0.0 : -fastest, fastest, "m/s");
  require_between("load", load, 0.0, heaviest, "N");
  if (stroke != nullptr) {
    stroke->forces.change(speed, load);
  } else {
    auto& lead = std::get<TouchLead>(running.contact);
    lead.speed = speed;
    lead.load = load;
    of_bows_.push_back({.start = now_, .body = running.body, .action = lead});
  }
  running.heard = now_;
}

void LiveStrokes::end(const std::string& name) {
  Running& running = find(name);
  if (auto* stroke = std::get_if<Stroke>(&running.contact)) {
    stroke->forces.end();
    ending_.emplace_back(running.body, std::move(*stroke));
  } else {
    TouchLead lead = std::get<TouchLead>(running.contact);
    lead.load = 0.0;
    lead.ends = true;
    of_bows_.push_back({.start = now_, .body = running.body, .action = lead});
  }
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
void LiveStrokes::go_on(std::size_t body, Stroke& stroke, std::vector<Event>& events) const {
  for (; stroke.next < now_ + lead_ + 2 * block && !stroke.forces.is_over(); stroke.next += block) {
    events.push_back({.start = stroke.next,
                      .body = body,
                      .action = Excitation{.forces = stroke.forces.next(stroke.next),
                                           .strength = stroke.strength,
                                           .begins = std::exchange(stroke.begins, false)}});
  }
}

void LiveStrokes::ask(std::int64_t now, std::vector<Event>& events) {
  now_ = now;
  end_forgotten();
  for (auto& [name, running] : running_) {
    if (auto* stroke = std::get_if<Stroke>(&running.contact)) {
      go_on(running.body, *stroke, events);
    }
  }
  for (auto& [body, stroke] : ending_) {
    go_on(body, stroke, events);
  }
  std::erase_if(ending_, [](const auto& ending) { return ending.second.forces.is_over(); });
  std::ranges::move(of_bows_, std::back_inserter(events));
  of_bows_.clear();
}

}  // namespace idiophone::drivers

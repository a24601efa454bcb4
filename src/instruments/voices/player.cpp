#include "player.hpp"

#include <algorithm>

namespace idiophone::voices {

namespace {

constexpr auto silence_interval = static_cast<std::int64_t>(resonators::ResonatorBank::most_samples);

std::int64_t end_of(const ForceCommand& excitation) {
  return excitation.start + static_cast<std::int64_t>(excitation.force.size());
}

std::int64_t end_of(const TouchCommand& touch) {
  return touch.start + touch.length + touch.rest;
}

std::int64_t start_of(const Command& command) {
  return std::visit([](const auto& one) { return one->start; }, command);
}

bool is_for_good(const Command& command) {
  const auto* change = std::get_if<std::unique_ptr<ReceptionChange>>(&command);
  return change != nullptr && (*change)->leaves;
}

}  // namespace

Player::Player(MappedSound sound, std::size_t receivers, int rate, std::size_t most_commands)
    : sound_(std::move(sound)),
      receivers_(receivers),
      rate_(rate),
      incoming_(most_commands + 1),
      done_(most_commands + 1),
      most_commands_(most_commands) {
  waiting_.reserve(most_commands + 1);
  acting_.reserve(most_commands);
  touches_.reserve(resonators::PointContacts::most);
  drives_.reserve(most_commands);
}

bool Player::send(Command& command) {
  const std::size_t most = most_commands_ + (is_for_good(command) ? 1 : 0);
  if (outstanding_ >= most || !incoming_.put(command)) {
    return false;
  }
  ++outstanding_;
  return true;
}

void Player::collect() {
  for (Command command; done_.take(command); command = {}) {
    --outstanding_;
  }
}

Waits Player::waits() const {
  const std::int64_t count = measured_waits_;
  return {.count = count,
          .mean = count > 0 ? 1e-9 * static_cast<double>(total_wait_) / static_cast<double>(count) : 0.0,
          .longest = 1e-9 * static_cast<double>(longest_wait_)};
}

void Player::hand_back(Command command) {
  done_.put(command);  // there is room: no more than most_commands_ + 1 are outstanding
}

void Player::begin(std::unique_ptr<ForceCommand> excitation, std::int64_t sample) {
  excitation->start = sample;
  if (excitation->sent != 0) {
    const std::int64_t time = clock_ + (sample - block_start_) * 1'000'000'000 / rate_;
    ++measured_waits_;
    total_wait_ += time - excitation->sent;
    longest_wait_ = std::max(longest_wait_.load(), time - excitation->sent);
  }
  take_strength(excitation->strength);
  acting_.push_back(std::move(excitation));
}

void Player::take_strength(double strength) {
  const bool was_silent = !is_driven() && !sound_.sounds();
  strength_ = std::max(was_silent ? 0.0 : strength_, strength);
}

double Player::priority(proxies::Priority kind) const {
  const ListenerFromBody& listener = sound_.listener();
  switch (kind) {
    case proxies::Priority::distance:
      return listener.attention / listener.distance;
    case proxies::Priority::loudness:
    case proxies::Priority::audibility:
      return listener.attention * strength_ / listener.distance;
    case proxies::Priority::fixed:
      return own_priority_ < 0.0 ? own_priority_ / listener.attention : own_priority_ * listener.attention;
  }
  return 0.0;
}

bool Player::perform(Command& command, std::int64_t sample) {
  if (auto* excitation = std::get_if<std::unique_ptr<ForceCommand>>(&command)) {
    begin(std::move(*excitation), sample);
    return true;
  }
  if (auto* touch = std::get_if<std::unique_ptr<TouchCommand>>(&command)) {
    const bool has_room = touches_.size() < resonators::PointContacts::most;
    if (has_room) {
      begin(std::move(*touch), sample);
    }
    return has_room;
  }
  if (const auto* change = std::get_if<std::unique_ptr<ReceptionChange>>(&command)) {
    if (sound_.is_changing(sample) && !(*change)->leaves) {
      return false;
    }
    if (!sound_.leaves()) {
      sound_.begin(**change, sample);
    }
  } else if (const auto* retuning = std::get_if<std::unique_ptr<Retuning>>(&command)) {
    retune(**retuning);
  } else {
    lead(*std::get<std::unique_ptr<LeadCommand>>(command), sample);
  }
  hand_back(std::move(command));
  return true;
}

void Player::begin_due(std::int64_t sample) {
  // Not std::remove_if, because it may not change what it looks at.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (start_of(waiting_[i]) > sample || !perform(waiting_[i], sample)) {
      if (kept != i) {
        waiting_[kept] = std::move(waiting_[i]);
      }
      ++kept;
    }
  }
  waiting_.resize(kept);
}

void Player::end_over(std::int64_t sample) {
  for (const auto& touch : touches_) {
    if (sample % silence_interval == 0 && touch->contact->is_over()) {  // at samples that do not depend on blocks
      touch->length = std::min(touch->length, sample - touch->start);
    }
    if (end_of(*touch) <= sample) {
      contacts_->remove(*touch->contact);
    }
  }
  const auto end_all = [&](auto& commands) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (end_of(*commands[i]) <= sample) {
        hand_back(std::move(commands[i]));
      } else {
        if (kept != i) {
          commands[kept] = std::move(commands[i]);
        }
        ++kept;
      }
    }
    commands.resize(kept);
  };
  end_all(acting_);
  end_all(touches_);
}

std::int64_t Player::next_boundary(std::int64_t sample, std::int64_t end) const {
  std::int64_t next = std::min(end, (sample / silence_interval + 1) * silence_interval);
  for (const Command& command : waiting_) {
    if (start_of(command) > sample) {
      next = std::min(next, start_of(command));
    }
  }
  for (const auto& excitation : acting_) {
    const std::int64_t over = excitation->start + excitation->acts_for;
    next = std::min(next, over > sample ? over : end_of(*excitation));
  }
  for (const auto& touch : touches_) {
    next = std::min(next, end_of(*touch));
  }
  if (sound_.is_changing(sample)) {
    next = std::min(next, sound_.change_end());
  }
  return next;
}

void Player::prepare(std::int64_t sample, std::size_t samples) {
  drives_.clear();
  for (const auto& excitation : acting_) {
    const auto offset = static_cast<std::size_t>(sample - excitation->start);
    drives_.push_back({.force = std::span(excitation->force).subspan(offset, samples),
                       .by_mean = excitation->by_mean,
                       .by_slope = excitation->by_slope,
                       .acts = static_cast<std::int64_t>(offset) < excitation->acts_for});
  }
  if (sample % silence_interval == 0) {
    sound_.silence();
  }
}

void Player::join(resonators::PointContacts& contacts, std::size_t body, bool touches) {
  contacts_ = &contacts;
  number_ = body;
  touches_something_ = touches;
}

void Player::begin_piece(std::int64_t begin, std::int64_t clock) {
  for (Command command; incoming_.take(command);) {
    waiting_.push_back(std::move(command));
  }
  clock_ = clock;
  block_start_ = begin;
  sound_.begin_piece();
}

void Player::begin_and_end_due(std::int64_t sample) {
  end_over(sample);
  begin_due(sample);
}

void Player::render(std::int64_t sample, std::span<double> sound) {
  prepare(sample, sound.size() / receivers_);
  sound_.render(sample, drives_, *contacts_, sound);
  note_leaving();
}

resonators::BodyInContact Player::begin_contact(std::int64_t sample, std::size_t samples) {
  prepare(sample, samples);
  return sound_.begin_contact(sample, drives_, samples);
}

void Player::end_contact(std::int64_t sample, std::span<double> sound) {
  sound_.end_contact(sample, sound);
  note_leaving();
}

void Player::note_leaving() {
  if (sound_.has_left()) {
    has_left_.store(true, std::memory_order_relaxed);
  }
}

}  // namespace idiophone::voices

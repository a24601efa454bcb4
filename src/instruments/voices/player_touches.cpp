// Contacts in the audio thread that feel the body.

#include <algorithm>
#include <utility>

#include "player.hpp"

namespace idiophone::voices {

void Player::begin(std::unique_ptr<TouchCommand> touch, std::int64_t sample) {
  touch->start = sample;
  take_strength(touch->strength);
  const resonators::TouchedPoint point{.body = number_, .point = &touch->point};
  contacts_->add(*touch->contact, {&point, 1});
  touches_.push_back(std::move(touch));
}

void Player::lead(const LeadCommand& command, std::int64_t sample) {
  for (const auto& touch : touches_) {
    if (touch->number == command.number) {
      touch->contact->lead(command.motion, command.length);
      touch->length = command.ends ? sample + command.length - touch->start : touch->length;
    }
  }
}

/// Contacts that begin later were asked for before, too.
void Player::retune(Retuning& retuning) {
  sound_.retune(retuning.turns, retuning.size);
  for (auto& [number, point] : retuning.points) {
    const auto takes = [number = number, &point = point](const std::unique_ptr<TouchCommand>& touch) {
      if (touch->number == number) {
        std::swap(touch->point, point);
      }
    };
    std::ranges::for_each(touches_, takes);
    for (const Command& command : waiting_) {
      if (const auto* touch = std::get_if<std::unique_ptr<TouchCommand>>(&command)) {
        takes(*touch);
      }
    }
  }
  contacts_->find_compliance();
}

}  // namespace idiophone::voices

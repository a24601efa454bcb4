#include "contact_group.hpp"

#include <algorithm>

namespace idiophone::voices {

ContactGroup::ContactGroup(std::vector<Player*> players, std::vector<StageContact> contacts, std::size_t channels,
                           int rate)
    : players_(std::move(players)),
      stage_contacts_(std::move(contacts)),
      channels_(channels),
      contacts_(rate, players_.size(), stage_contacts_.size()) {
  for (std::size_t body = 0; body < players_.size(); ++body) {
    const bool touches = std::ranges::any_of(stage_contacts_, [&](const StageContact& one) {
      return std::ranges::find(one.points, body, &StageContact::Point::body) != one.points.end();
    });
    players_[body]->join(contacts_, body, touches);
  }
  for (const StageContact& one : stage_contacts_) {
    std::vector<resonators::TouchedPoint> points;
    for (const StageContact::Point& point : one.points) {
      points.push_back({.body = point.body, .point = &point.point});
    }
    contacts_.add(*one.contact, points);
  }
  in_contact_.reserve(players_.size());
}

bool ContactGroup::is_idle() const {
  return std::ranges::all_of(players_, [](const Player* player) { return player->is_idle(); }) &&
         std::ranges::all_of(stage_contacts_, [](const StageContact& one) { return one.contact->is_at_rest(); });
}

bool ContactGroup::is_called() const {
  return std::ranges::any_of(players_, &Player::is_called);
}

void ContactGroup::render(std::span<double> sound, std::int64_t begin, std::int64_t clock) {
  if (sleeps_ && !is_called()) {
    return;
  }
  for (Player* player : players_) {
    player->begin_piece(begin, clock);
  }
  sleeps_ = is_idle();
  const std::int64_t end = begin + static_cast<std::int64_t>(sound.size() / channels_);
  for (std::int64_t sample = sleeps_ ? end : begin; sample < end;) {
    std::int64_t next = end;
    for (Player* player : players_) {
      player->begin_and_end_due(sample);
      next = std::min(next, player->next_boundary(sample, end));
    }
    const auto offset = static_cast<std::size_t>(sample - begin);
    render_samples(sample, sound.subspan(offset * channels_, static_cast<std::size_t>(next - sample) * channels_));
    sample = next;
  }
}

/// In which nothing begins or ends.
void ContactGroup::render_samples(std::int64_t sample, std::span<double> sound) {
  if (contacts_.count() == 0) {
    for (Player* player : players_) {
      player->render(sample, sound);
    }
    return;
  }
  in_contact_.clear();
  for (Player* player : players_) {
    in_contact_.push_back(player->begin_contact(sample, sound.size() / channels_));
  }
  resonators::advance_together(in_contact_, contacts_);
  for (Player* player : players_) {
    player->end_contact(sample, sound);
  }
}

}  // namespace idiophone::voices

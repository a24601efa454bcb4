#include "roster.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace idiophone::voices {

Roster::Roster(std::vector<std::unique_ptr<MapBody>> bodies, std::vector<std::unique_ptr<ContactGroup>> groups,
               const MapDetail& detail, std::size_t channels, int rate)
    : detail_(detail),
      channels_(channels),
      rate_(rate),
      bodies_(std::move(bodies)),
      groups_(std::move(groups)),
      leaves_(bodies_.size()),
      present_(made()) {}

std::unique_ptr<Lineup> Roster::made() const {
  auto lineup = std::make_unique<Lineup>();
  std::ranges::transform(bodies_, std::back_inserter(lineup->by_number), [](const auto& body) { return body.get(); });
  lineup->bodies = present();
  for (const auto& group : groups_) {
    if (group) {
      lineup->groups.push_back(group.get());
    }
  }
  lineup->choice = std::make_unique<ModeChoice>(detail_, lineup->bodies, channels_, rate_);
  lineup->sounding.reserve(lineup->bodies.size());
  return lineup;
}

std::vector<MapBody*> Roster::present() const {
  std::vector<MapBody*> all;
  for (const auto& body : bodies_) {
    if (body) {
      all.push_back(body.get());
    }
  }
  return all;
}

void Roster::join(std::size_t number, std::unique_ptr<MapBody> body) {
  const std::size_t count = std::max(number + 1, bodies_.size());
  bodies_.resize(count);
  groups_.resize(count);
  leaves_.resize(count);
  groups_[number] =
      std::make_unique<ContactGroup>(std::vector{&body->player()}, std::vector<StageContact>{}, channels_, rate_);
  bodies_[number] = std::move(body);
  leaves_[number] = 0;
  has_changed_ = true;
}

void Roster::leave(std::size_t number) {
  bodies_[number]->leave();
  leaves_[number] = 1;
}

/// Those that have faded.
void Roster::dismiss() {
  for (std::size_t number = 0; number < bodies_.size(); ++number) {
    if (leaves_[number] != 0 && bodies_[number]->player().has_left()) {
      gone_.push_back({.body = std::move(bodies_[number]), .group = std::move(groups_[number]), .lineup = newest_ + 1});
      leaves_[number] = 0;
      has_changed_ = true;
    }
  }
}

void Roster::attend() {
  for (std::unique_ptr<Lineup> old; returned_.take(old);) {
    ++in_use_;
  }
  std::erase_if(gone_, [&](const Gone& one) { return one.lineup <= in_use_; });
  for (MapBody* body : present()) {
    body->attend();
  }
  dismiss();
  if (has_changed_ && newest_ - in_use_ < most_on_their_way) {
    std::unique_ptr<Lineup> next = made();
    coming_.put(next);
    ++newest_;
    has_changed_ = false;
  }
}

/// The old one is handed back, because only the control thread may free it. There is room for all on their way.
Lineup& Roster::lineup() {
  for (std::unique_ptr<Lineup> next; coming_.take(next);) {
    next->choice->go_on_from(*present_->choice);
    std::swap(present_, next);
    returned_.put(next);
  }
  return *present_;
}

}  // namespace idiophone::voices

#include "map_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/place_text.hpp"
#include "listener_change.hpp"

namespace idiophone::voices {

namespace {

constexpr std::size_t most_queued = 4096;

}  // namespace

MapBody::MapBody(std::shared_ptr<const PreparedMap> map, const Audience& audience, std::vector<HearingPoint> points,
                 int rate, const MapDetail& detail)
    : instrument_(std::move(map), rate),
      audience_(audience),
      points_(std::move(points)),
      behind_(detail.behind),
      player_(MappedSound(instrument_.bank(), audience.receivers(), first_reception(), rate), audience.receivers(),
              rate, detail.most_commands) {}

/// Where the listener is or goes, or at the listeners of the map without points.
Reception MapBody::reception() const {
  Reception reception = points_.empty() ? instrument_.at_listeners() : instrument_.at(points_);
  const Vector3 way = middle_of(points_.empty() ? audience_.points(0.0) : points_) - map().centre;
  constexpr double nearest = 0.01;  // m
  reception.listener = {.distance = std::max(nearest, way.norm()),
                        .attention = way.dot(audience_.look()) > 0.0 ? behind_ : 1.0};
  if (audience_.has_head()) {
    reception.head = audience_.head_responses(map().centre, points_.front());
  }
  return reception;
}

/// @throws std::runtime_error when it is too far away, or the map has other listeners than the audience
Reception MapBody::first_reception() const {
  if (audience_.is_fixed() && map().listeners.size() != audience_.receivers()) {
    throw std::runtime_error(fmt::format("the sound map of {} has {} listeners, but {} are to hear it", map().body,
                                         map().listeners.size(), audience_.receivers()));
  }
  Reception first = reception();
  const std::size_t receivers = points_.empty() ? audience_.receivers() : points_.size();
  for (std::size_t r = 0; r < receivers; ++r) {
    const double way = first.delay.at(r) / instrument_.rate();
    if (way > longest_way) {
      throw std::runtime_error(fmt::format("a listener is {:.4g} s of sound away from {}; at most {} s can be played",
                                           way, map().body, longest_way));
    }
  }
  return first;
}

void MapBody::require_in_reach(const Vector3& place) const {
  if ((place - map().centre).norm() > 0.99 * longest_way * map().air_speed) {
    throw std::runtime_error(fmt::format("{} is too far away from {} for a listener", to_text(place), map().body));
  }
}

void MapBody::excite(const drivers::Excitation& excitation, std::int64_t sent) {
  if (sent != 0 && !queued_.empty()) {
    throw std::runtime_error("too much is played at once");
  }
  for (const resonators::PointForce& force : excitation.forces) {
    std::unique_ptr<ForceCommand> command = instrument_.excite(force.at, force.direction, force.force);
    command->start = force.start;
    command->sent = excitation.forces.size() == 1 ? sent : 0;
    queued_.emplace_back(std::move(command));
  }
  attend();
}

/// What is heard of the modes changes, too, but on a path the next piece does that.
void MapBody::tune(const score::Tuning& tuning, std::int64_t start) {
  if (queued_.size() >= most_queued) {
    throw std::runtime_error("too many changes of a body are waiting");
  }
  instrument_.tune(tuning);
  auto retuning = std::make_unique<Retuning>();
  retuning->start = start;
  retuning->turns = resonators::in_groups(instrument_.turns());
  retuning->size = tuning.size;
  for (const Contact& contact : contacts_) {
    retuning->points.emplace_back(contact.command, instrument_.contact_point(contact.at, contact.direction));
  }
  queued_.emplace_back(std::move(retuning));
  if (!audience_.moves()) {
    queue_change(start, change_length);
  }
  attend();
}

void MapBody::touch(const drivers::Touching& touch, std::int64_t start) {
  constexpr std::size_t most = resonators::PointContacts::most;
  std::erase_if(contacts_, [&](const Contact& contact) { return contact.end <= start; });
  if (contacts_.size() == most) {
    throw std::runtime_error(
        fmt::format("{} bows and mallets touch {} already; no more are possible", most, map().body));
  }
  std::unique_ptr<TouchCommand> command =
      std::visit([&](const auto& contact) { return instrument_.touch(contact); }, touch.contact);
  command->start = start;
  command->number = touches_++;
  const auto* bow = std::get_if<score::Bow>(&touch.contact);
  const auto* mallet = std::get_if<score::MalletBlow>(&touch.contact);
  contacts_.push_back({.command = command->number,
                       .touch = touch.number,
                       .end = start + command->length + command->rest,
                       .rest = command->rest,
                       .at = bow != nullptr ? bow->at : mallet->blow.at,
                       .direction = bow != nullptr ? bow->direction : mallet->blow.direction});
  queued_.emplace_back(std::move(command));
  attend();
}

resonators::ContactPoint MapBody::contact_point(const Vector3& at, const Vector3& direction) const {
  instrument_.require_modes();
  return instrument_.contact_point(at, direction);
}

void MapBody::lead(const drivers::TouchLead& lead, std::int64_t start) {
  for (Contact& contact : contacts_) {
    if (contact.touch != lead.number) {
      continue;
    }
    auto command = std::make_unique<LeadCommand>();
    *command = {.start = start,
                .number = contact.command,
                .length = drivers::TouchLead::length,
                .motion = {.speed = lead.speed, .load = lead.load},
                .ends = lead.ends};
    queued_.emplace_back(std::move(command));
    contact.end = lead.ends ? start + drivers::TouchLead::length + contact.rest : contact.end;
  }
  attend();
}

void MapBody::hear_at(const ListenerPlace& place) {
  points_ = place.points;
  queue_change(place.start, place.length);
  attend();
}

void MapBody::leave() {
  auto change = std::make_unique<ReceptionChange>();
  change->length = MapChoice::interval;
  change->reception = reception();
  std::ranges::fill(change->reception.gains, resonators::ModeGroup{});
  change->leaves = true;
  queued_.clear();
  queued_.emplace_back(std::move(change));
  attend();
}

void MapBody::attend() {
  player_.collect();
  while (!queued_.empty() && player_.send(queued_.front())) {
    queued_.pop_front();
  }
}

void MapBody::queue_change(std::int64_t start, std::int64_t length) {
  auto change = std::make_unique<ReceptionChange>();
  change->start = start;
  change->length = length;
  change->reception = reception();
  queued_.emplace_back(std::move(change));
}

}  // namespace idiophone::voices

#include "idiophone/air/propagation/ears.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/place_text.hpp"

namespace idiophone::propagation {

namespace {

/// How often a head's directions are updated.
constexpr int direction_updates_per_second = 100;

std::unique_ptr<radiation::Model> make_model(scene::RadiationModel model, const radiation::Medium& air) {
  switch (model) {
    case scene::RadiationModel::rayleigh:
      return std::make_unique<radiation::Rayleigh>(air);
    case scene::RadiationModel::kirchhoff:
      return std::make_unique<radiation::Kirchhoff>(air);
    case scene::RadiationModel::waves:
      return std::make_unique<radiation::KirchhoffHelmholtz>(air);
    case scene::RadiationModel::huygens:
      break;
  }
  return std::make_unique<radiation::Huygens>();
}

/// The paper's spreading for the paper's model; the other models need exact levels.
const receivers::Spreading& spreading_of(scene::RadiationModel model) {
  return model == scene::RadiationModel::huygens ? receivers::Spreading::splat() : receivers::Spreading::band_limited();
}

}  // namespace

void check_heads(const scene::Acoustics& acoustics) {
  for (const auto& listener : acoustics.listeners) {
    if (listener.head) {
      try {
        const receivers::HeadResponses responses(listener.head->responses, acoustics.audio.rate);
      } catch (const std::runtime_error& error) {
        throw deck::DeckError(listener.head->where, "listeners." + listener.name + ".hrtf: " + error.what());
      }
    }
  }
}

Ears::Ears(const scene::Acoustics& acoustics, std::int64_t first, std::size_t triangles)
    : Ears(acoustics, first, triangles,
           make_model(acoustics.radiation.model, {acoustics.radiation.air.speed, acoustics.audio.rate}),
           spreading_of(acoustics.radiation.model)) {}

Ears::Ears(const scene::Acoustics& acoustics, std::int64_t first, std::size_t triangles,
           std::unique_ptr<radiation::Model> model, const receivers::Spreading& spreading)
    : acoustics_(acoustics),
      air_{acoustics.radiation.air.speed, acoustics.audio.rate},
      model_(std::move(model)),
      spreading_(spreading),
      images_(image_paths(acoustics.radiation)) {
  air_.validate();
  for (const auto& listener : acoustics.listeners) {
    const std::size_t members = listener.head ? 1 : listener.receivers.size();
    for (std::size_t r = 0; r < members; ++r) {
      add(listener, listener.receivers[r], first, triangles);
    }
  }
  if (const auto& room = acoustics.radiation.room; room && room->late) {
    add_late_field(first);
  }
}

void Ears::add_late_field(std::int64_t first) {
  std::vector<LateField::Listener> listeners;
  for (const Member& member : ears_) {
    listeners.push_back({member.receiver->directivity, member.ear.head()});
  }
  late_.emplace(acoustics_.radiation, air_, first + spreading_.first(), spreading_, std::move(listeners));
}

void Ears::add(const scene::Listener& listener, const scene::Receiver& receiver, std::int64_t first,
               std::size_t triangles) {
  const auto& air = acoustics_.radiation.air;
  receivers::EarOptions options{.head = find_head(listener),
                                .air = {},
                                .walls = absorbing_walls(acoustics_.radiation, images_, air_.rate),
                                .direction_interval = std::max(1, air_.rate / direction_updates_per_second),
                                .triangles = triangles,
                                .paths = 1 + images_.size()};
  if (!acoustics_.radiation.screens.empty()) {
    options.edges.emplace(air_.rate);
  }
  if (air.absorption) {
    options.air.emplace(radiation::Atmosphere{air.temperature, air.humidity, air.pressure}, air_.rate);
  }
  ears_.push_back({&listener, &receiver,
                   receivers::Ear(first + spreading_.first(), radiation::longest_distance * air_.samples_per_metre(),
                                  spreading_, std::move(options))});
}

std::shared_ptr<const receivers::HeadResponses> Ears::find_head(const scene::Listener& listener) const {
  return listener.head ? std::make_shared<const receivers::HeadResponses>(listener.head->responses, air_.rate)
                       : nullptr;
}

Ears::Stand Ears::stand(std::int64_t sample, const Member& member) const {
  const auto& [listener, receiver, ear] = member;
  const scene::Place place = listener->place(*receiver, static_cast<double>(sample) / air_.rate);
  Stand stand{.receiver = {.position = place.position,
                           .velocity = place.velocity,
                           .axis = receiver->axis,
                           .directivity = receiver->directivity}};
  if (const auto& head = listener->head) {
    stand.frame << head->look.transpose(), head->up.cross(head->look).transpose(), head->up.transpose();
  }
  if (listener->attached && frames_ != nullptr) {
    const BodyFrames::Carrier body = frames_->at(*listener->attached, sample);
    stand.receiver.position = body.position(place.position);
    stand.receiver.velocity = body.velocity_at(stand.receiver.position);
    stand.receiver.axis = body.turn * receiver->axis;
    stand.frame = (stand.frame * body.turn.transpose()).eval();
  }
  return stand;
}

Ears::Stand Ears::mirrored(const Stand& stand, const ImagePath& path) {
  Stand image{.receiver = propagation::image(stand.receiver, path), .frame = stand.frame};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    image.frame.row(axis) = path.mirrored(stand.frame.row(axis).transpose()).transpose();
  }
  return image;
}

void Ears::require_inside(std::int64_t sample, const surface::Emission& emission) const {
  const auto require = [&](std::string_view what, const Vector3& place) {
    const scene::Room& room = *acoustics_.radiation.room;
    if (room.distance_outside(place) > 0.0) {
      throw std::runtime_error(
          fmt::format("{} is outside radiation.room ({}), at {}, at {:.4g} s; move it, or make the "
                      "room larger",
                      what, deck::to_string(room.where), to_text(place), static_cast<double>(sample) / air_.rate));
    }
  };
  for (std::size_t i = 0; i < emission.pressure.size(); ++i) {
    if (emission.area[i] != 0.0 || emission.pressure[i] != 0.0) {  // the others are padding
      require("something that sounds", {emission.centre[0][i], emission.centre[1][i], emission.centre[2][i]});
    }
  }
  for (const Member& member : ears_) {
    require(member.receiver->channel, stand(sample, member).receiver.position);
  }
}

void Ears::hear(std::int64_t sample, const surface::Emission& emission, const LineOfSight* sight,
                const SoundAt& sound_at) {
  const bool in_room = acoustics_.radiation.room.has_value();
  if (in_room) {
    require_inside(sample, emission);
  }
  for (std::size_t e = 0; e < ears_.size(); ++e) {
    const Stand straight = stand(sample, ears_[e]);
    if (const auto sounds = sound_at ? sound_at(straight.receiver.position) : std::nullopt) {
      hear_here(sample, *sounds, ears_[e].ear);
      if (!in_room) {
        continue;
      }
    } else {
      hear_directly(sample, emission, straight, sight, e);
    }
    for (std::size_t path = 0; path < images_.size(); ++path) {
      const Stand image = mirrored(straight, images_[path]);
      radiation::find_paths(emission, image.receiver, air_, paths_);
      radiate(sample, emission, image, path + 1, ears_[e].ear);
    }
  }
  if (late_) {
    late_->hear(sample, emission, *model_);
  }
}

void Ears::hear_directly(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                         const LineOfSight* sight, std::size_t ear) {
  radiation::find_paths(emission, stand.receiver, air_, paths_);
  if (sight != nullptr) {
    sight->fade(sample, ear, paths_);
  }
  radiate(sample, emission, stand, 0, ears_[ear].ear);
  for (std::size_t edge = 0; sight != nullptr && edge < sight->edges(); ++edge) {
    if (sight->is_heard(ear, edge)) {
      hear_around(sample, emission, stand, *sight, edge, ear);
    }
  }
}

void Ears::hear_around(std::int64_t sample, const surface::Emission& emission, const Stand& stand,
                       const LineOfSight& sight, std::size_t edge, std::size_t ear) {
  const std::size_t count = emission.pressure.size();
  for (auto* values : {&bent_paths_.distance, &bent_paths_.delay, &bent_paths_.cosine, &bent_paths_.gain}) {
    values->assign(count, values == &bent_paths_.distance ? 1.0 : 0.0);
  }
  for (std::size_t wave = 0; wave < 2; ++wave) {
    edge_gains_.at(wave).assign(count, 0.0);
    edge_numbers_.at(wave).assign(count, receivers::EdgeFilters::lowest);
  }
  const radiation::ReceiverState& receiver = stand.receiver;
  for (std::size_t i = 0; i < sight.triangles(); ++i) {
    const BentWay way = sight.bend(sample, ear, edge, i);
    if (way.is_silent()) {
      continue;
    }
    const Vector3 centre(emission.centre[0][i], emission.centre[1][i], emission.centre[2][i]);
    const Vector3 normal(emission.normal[0][i], emission.normal[1][i], emission.normal[2][i]);
    const Vector3 there = way.apex - centre;
    const Vector3 onwards = receiver.position + paths_.delay[i] / air_.rate * receiver.velocity - way.apex;
    const double distance = std::max(there.norm() + onwards.norm(), radiation::smallest_distance);
    bent_paths_.distance[i] = distance;
    bent_paths_.delay[i] = distance * air_.samples_per_metre();
    bent_paths_.cosine[i] = there.normalized().dot(normal);
    const double off_axis = onwards.normalized().dot(receiver.axis);
    const double gain = receiver.gain * (1.0 - receiver.directivity - receiver.directivity * off_axis);
    for (std::size_t wave = 0; wave < 2; ++wave) {
      edge_gains_.at(wave)[i] = gain * way.gains.at(wave);
      edge_numbers_.at(wave)[i] = way.numbers.at(wave);
    }
  }
  for (std::size_t wave = 0; wave < 2; ++wave) {
    bent_paths_.gain = edge_gains_.at(wave);
    model_->radiate(emission, bent_paths_, arrivals_);
    ears_[ear].ear.hear_edge(sample, arrivals_, bent_paths_.distance, edge_numbers_.at(wave));
  }
}

void Ears::radiate(std::int64_t sample, const surface::Emission& emission, const Stand& stand, std::size_t path,
                   receivers::Ear& ear) {
  const radiation::ReceiverState& receiver = stand.receiver;
  model_->radiate(emission, paths_, arrivals_);
  ear.hear(sample, path, arrivals_, paths_.distance, [&](std::size_t triangle) -> Vector3 {
    const Vector3 centre(emission.centre[0][triangle], emission.centre[1][triangle], emission.centre[2][triangle]);
    return stand.frame * (centre - receiver.position - paths_.delay[triangle] / air_.rate * receiver.velocity);
  });
}

void Ears::hear_here(std::int64_t sample, const LocalSounds& sounds, receivers::Ear& ear) {
  arrivals_.sound.assign(sounds.begin(), sounds.end());
  arrivals_.change.clear();
  arrivals_.delay.assign(sounds.size(), 0.0);
  ear.hear(sample, 0, arrivals_, arrivals_.delay, [](std::size_t) -> Vector3 {
    throw std::runtime_error("a head cannot be inside the grid of the waves; move it away, or use a microphone");
  });
}

std::vector<Vector3> Ears::positions(std::int64_t sample) const {
  std::vector<Vector3> positions;
  for (const auto& member : ears_) {
    positions.push_back(stand(sample, member).receiver.position);
  }
  return positions;
}

std::int64_t Ears::final_before(std::int64_t sample) const {
  const auto lookahead = static_cast<std::int64_t>(ears_.front().ear.bank().lookahead());  // of all ears alike
  return sample + 1 + spreading_.first() - lookahead;
}

std::vector<std::vector<double>> Ears::take(std::size_t count, MPI_Comm communicator) {
  std::vector<std::vector<double>> sounds;
  const auto lead = static_cast<std::size_t>(std::max<std::int64_t>(0, -ears_.front().ear.bank().first()));  // of all
  const std::vector<std::vector<double>> late = late_ ? late_->take(count, communicator) : sounds;
  auto late_channel = late.begin();
  auto member = ears_.begin();
  for (const auto& listener : acoustics_.listeners) {
    const std::size_t width = listener.receivers.size();
    auto& sound = sounds.emplace_back(width * count);
    for (std::size_t column = 0; column < width; column += (member++)->ear.channels()) {
      const std::vector<std::vector<double>> channels = member->ear.bank().take(lead + count, communicator);
      for (std::size_t c = 0; c < channels.size(); ++c) {
        for (std::size_t i = 0; i < count; ++i) {
          sound[i * width + column + c] = channels[c][lead + i];
        }
        if (late_) {
          for (std::size_t i = 0; i < count; ++i) {
            sound[i * width + column + c] += (*late_channel)[i];
          }
          ++late_channel;
        }
      }
    }
  }
  return sounds;
}

void Ears::archive(parallel::Archive& archive, const parallel::Rows& triangles) {
  for (std::size_t e = 0; e < ears_.size(); ++e) {
    ears_[e].ear.bank().archive(archive, fmt::format("listening/ear_{}", e));
  }
  if (late_) {
    late_->archive(archive);
  }
  archive.rows("listening/heads", triangles, [this](std::size_t triangle, parallel::ArchiveRow& row) {
    for (Member& member : ears_) {
      member.ear.archive(triangle, row);
    }
  });
}

}  // namespace idiophone::propagation

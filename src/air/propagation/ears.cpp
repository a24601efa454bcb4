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
  if (!acoustics_.radiation.screens.empty() || acoustics_.radiation.diffraction) {
    const bool one_screen = !acoustics_.radiation.diffraction && acoustics_.radiation.screens.size() == 1;
    options.edges.emplace(air_.rate, one_screen ? 1 : radiation::most_in_turn);  // a way touches one edge of a screen
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

std::vector<Vector3> Ears::path_ends(std::int64_t sample, std::size_t ear) const {
  const Stand straight = stand(sample, ears_[ear]);
  std::vector<Vector3> ends = {straight.receiver.position};
  for (const ImagePath& path : images_) {
    ends.push_back(mirrored(straight, path).receiver.position);
  }
  return ends;
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

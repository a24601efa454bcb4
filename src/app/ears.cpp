#include "ears.hpp"

#include <algorithm>

namespace idiophone::app {

namespace {

std::unique_ptr<radiation::Model> make_model(scene::RadiationModel model, const radiation::Air& air) {
  switch (model) {
    case scene::RadiationModel::rayleigh:
      return std::make_unique<radiation::Rayleigh>(air);
    case scene::RadiationModel::kirchhoff:
      return std::make_unique<radiation::Kirchhoff>(air);
    case scene::RadiationModel::huygens:
      break;
  }
  return std::make_unique<radiation::Huygens>();
}

/// The paper's for the paper's model; the others are levels to be trusted.
const listening::Spreading& spreading(scene::RadiationModel model) {
  return model == scene::RadiationModel::huygens ? listening::Spreading::splat() : listening::Spreading::band_limited();
}

}  // namespace

Ears::Ears(const scene::Scene& scene, std::int64_t first)
    : scene_(scene),
      air_{scene.radiation.air.speed, scene.audio.rate},
      model_(make_model(scene.radiation.model, air_)),
      spreading_(spreading(scene.radiation.model)) {
  air_.validate();
  for (const auto& listener : scene.listeners) {
    for (const auto& receiver : listener.receivers) {
      receivers_.push_back({.position = receiver.position});
      buffers_.emplace_back(first + spreading_.first(), radiation::longest_distance * air_.samples_per_metre(),
                            spreading_);
    }
  }
}

void Ears::hear(std::int64_t sample, const surface::Emission& emission, const LineOfSight* sight) {
  for (std::size_t r = 0; r < receivers_.size(); ++r) {
    radiation::find_paths(emission, receivers_[r], air_, paths_);
    if (sight != nullptr) {
      sight->fade(sample, r, paths_);
    }
    model_->radiate(emission, paths_, arrivals_);
    buffers_[r].add(sample, arrivals_);
  }
}

std::vector<Vector3> Ears::positions() const {
  std::vector<Vector3> positions;
  std::ranges::transform(receivers_, std::back_inserter(positions), &radiation::Receiver::position);
  return positions;
}

void Ears::drop_lead() {
  for (auto& buffer : buffers_) {
    if (buffer.first() < 0) {
      (void)buffer.take(static_cast<std::size_t>(-buffer.first()));
    }
  }
}

std::vector<std::vector<double>> Ears::take(std::size_t count, MPI_Comm communicator) {
  std::vector<std::vector<double>> sounds;
  auto buffer = buffers_.begin();
  for (const auto& listener : scene_.listeners) {
    const std::size_t width = listener.receivers.size();
    auto& sound = sounds.emplace_back(width * count);
    for (std::size_t r = 0; r < width; ++r) {
      const auto channel = listening::values(listening::sum_over_ranks((buffer++)->take(count), communicator));
      for (std::size_t i = 0; i < channel.size(); ++i) {
        sound[i * width + r] = channel[i];
      }
    }
  }
  return sounds;
}

std::vector<std::vector<std::int64_t>> Ears::pending(MPI_Comm communicator) const {
  std::vector<std::vector<std::int64_t>> words;
  for (const auto& buffer : buffers_) {
    auto& channel = words.emplace_back();
    for (const FixedPoint& entry : listening::sum_over_ranks(buffer.pending(), communicator)) {
      channel.insert(channel.end(), {entry.coarse, entry.fine});
    }
  }
  return words;
}

void Ears::restore(std::int64_t first, const std::vector<std::vector<std::int64_t>>& pending) {
  for (std::size_t r = 0; r < buffers_.size(); ++r) {
    std::vector<FixedPoint> entries;
    for (std::size_t i = 0; !pending.empty() && i + 1 < pending[r].size(); i += 2) {
      entries.push_back({pending[r][i], pending[r][i + 1]});
    }
    buffers_[r].restore(first, std::move(entries));
  }
}

}  // namespace idiophone::app

#include "idiophone/air/propagation/late_field.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "late_tail.hpp"

namespace idiophone::propagation {

namespace {

/// Places in the directions of the late field, as far as its paths have come by then.
std::vector<radiation::ReceiverState> receivers_around(const scene::Radiation& radiation) {
  std::vector<radiation::ReceiverState> around;
  for (const LateDirection& late : late_directions(radiation)) {
    around.push_back({.position = radiation.room->centre() + late.distance * late.direction});
  }
  return around;
}

/// Filter number n gives its input to channel n.
receivers::Filters to_channels(std::size_t channels) {
  return {.channels = channels, .make = [channels](std::int64_t number) {
            receivers::Responses responses(channels, std::vector<double>(1));
            responses.at(number).front() = 1.0;
            return responses;
          }};
}

/// Amplitude of a diffuse field behind a microphone's pattern: the root of the mean square over all directions.
double diffuse_gain(double directivity) {
  return std::sqrt(std::pow(1.0 - directivity, 2) + directivity * directivity / 3.0);
}

/// The tail as it arrives at each channel of a listener.
receivers::Responses heard(const std::vector<double>& tail, const LateField::Listener& listener,
                           const Vector3& direction) {
  if (!listener.head) {
    std::vector<double> scaled = tail;
    std::ranges::for_each(scaled, [&](double& tap) { tap *= diffuse_gain(listener.directivity); });
    return {scaled};
  }
  receivers::Responses responses = listener.head->responses(listener.head->nearest(direction));
  for (std::vector<double>& response : responses) {
    std::vector<double> padded(2 * (response.size() - 1) + tail.size());
    std::ranges::copy(tail, padded.begin() + static_cast<std::ptrdiff_t>(response.size() - 1));
    response = receivers::convolve(padded, response);
  }
  return responses;
}

}  // namespace

LateField::LateField(const scene::Radiation& radiation, const radiation::Medium& air, std::int64_t first,
                     const receivers::Spreading& spreading, std::vector<Listener> listeners)
    : radiation_(radiation),
      air_(air),
      listeners_(std::move(listeners)),
      around_(receivers_around(radiation)),
      leaving_(first, radiation::longest_distance * air.samples_per_metre(), spreading, to_channels(around_.size())) {}

void LateField::hear(std::int64_t sample, const surface::Emission& emission, const radiation::Model& model) {
  for (std::size_t direction = 0; direction < around_.size(); ++direction) {
    radiation::find_paths(emission, around_[direction], air_, paths_);
    model.radiate(emission, paths_, arrivals_);
    leaving_.add(static_cast<std::int64_t>(direction), sample, arrivals_);
  }
}

void LateField::make_convolvers() {
  const std::vector<LateDirection> directions = late_directions(radiation_);
  const LateBands decay = late_decay(radiation_);
  std::uint64_t seed = 0;
  for (const Listener& listener : listeners_) {
    std::vector<std::vector<spectra::Convolver>> channels(listener.channels());
    for (const LateDirection& direction : directions) {
      const std::vector<double> tail = late_tail(direction, decay, air_.rate, ++seed);
      // The field is diffuse, so any direction of arrival will do.
      for (std::size_t channel = 0; const auto& response : heard(tail, listener, direction.direction)) {
        channels[channel++].emplace_back(response);
      }
    }
    std::ranges::move(channels, std::back_inserter(convolvers_));
  }
}

std::vector<std::vector<double>> LateField::take(std::size_t count, MPI_Comm communicator) {
  const auto lead = static_cast<std::size_t>(std::max<std::int64_t>(0, -leaving_.first()));
  const std::vector<std::vector<double>> leaving = leaving_.take(lead + count, communicator);
  if (!parallel::is_root(communicator)) {
    return {};
  }
  if (convolvers_.empty()) {
    make_convolvers();
  }
  std::vector<std::vector<double>> sounds(convolvers_.size(), std::vector<double>(count));
  std::vector<double> now(around_.size());
  for (std::size_t n = 0; n < lead + count; ++n) {
    std::ranges::transform(leaving, now.begin(), [n](const std::vector<double>& sound) { return sound[n]; });
    past_.insert(past_.end(), now.begin(), now.end());
    for (std::size_t channel = 0; channel < sounds.size(); ++channel) {
      for (std::size_t direction = 0; direction < now.size(); ++direction) {
        const double sound = convolvers_[channel][direction].step(now[direction]);
        if (n >= lead) {
          sounds[channel][n - lead] += sound;
        }
      }
    }
  }
  forget();
  return sounds;
}

void LateField::forget() {
  const std::size_t piece = spectra::Convolver::piece * around_.size();
  std::size_t remembered = 0;
  for (const auto& channel : convolvers_) {
    for (const spectra::Convolver& convolver : channel) {
      remembered = std::max(remembered, convolver.remembered_pieces());
    }
  }
  const std::size_t pieces = past_.size() / piece;
  if (pieces > 2 * remembered) {
    past_.erase(past_.begin(), past_.begin() + static_cast<std::ptrdiff_t>((pieces - remembered) * piece));
  }
}

void LateField::archive(parallel::Archive& archive) {
  leaving_.archive(archive, "listening/late");
  archive.root("listening/late_past", past_);
  if (!archive.restoring() || !parallel::is_root(archive.communicator())) {
    return;
  }
  convolvers_.clear();
  make_convolvers();
  for (auto& channel : convolvers_) {
    for (std::size_t i = 0; i < past_.size(); ++i) {
      channel[i % around_.size()].step(past_[i]);
    }
  }
}

}  // namespace idiophone::propagation

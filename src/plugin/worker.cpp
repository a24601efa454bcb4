#include "worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "idiophone/instruments/sound_maps/sound_map_file.hpp"

namespace idiophone::plugin {

Worker::Worker(int rate) : rate_(rate) {
  publish();
}

MapFiles Worker::files() const {
  const std::lock_guard lock(mutex_);
  return files_;
}

void Worker::read(std::size_t slot, const std::string& file) {
  files_.at(slot) = file;
  maps_.at(slot).reset();
  if (!file.empty()) {
    maps_.at(slot) = std::make_shared<const sound_maps::SoundMap>(sound_maps::read_sound_map(file));
  }
}

/// Makes a stage of the present maps and controls.
void Worker::publish() {
  Maps maps;
  std::ranges::copy_if(maps_, std::back_inserter(maps), [](const auto& map) { return map != nullptr; });
  played_.push_back(std::make_unique<PlayedMaps>(std::move(maps), controls_of(values_), rate_));
  newest_.store(played_.back().get(), std::memory_order_release);
}

void Worker::load(std::size_t slot, const std::string& file, const ControlValues& values) {
  const std::lock_guard lock(mutex_);
  values_ = values;
  std::string mistake;
  try {
    read(slot, file);
  } catch (const std::exception& error) {
    mistake = error.what();
  }
  publish();
  if (!mistake.empty()) {
    throw std::runtime_error(mistake);
  }
}

void Worker::load_all(const MapFiles& files) {
  const std::lock_guard lock(mutex_);
  std::string mistakes;
  for (std::size_t slot = 0; slot < map_slots; ++slot) {
    try {
      read(slot, files.at(slot));
    } catch (const std::exception& error) {
      mistakes += fmt::format("{}{}", mistakes.empty() ? "" : "; ", error.what());
    }
  }
  publish();
  if (!mistakes.empty()) {
    throw std::runtime_error(mistakes);
  }
}

void Worker::play(const Request& request) {
  const std::lock_guard lock(mutex_);
  while (played_.front().get() != request.sounding && played_.size() > 1) {
    played_.pop_front();
  }
  PlayedMaps& sounding = *played_.front();
  const bool is_newest = played_.size() == 1;
  if (is_newest && request.values != values_) {
    values_ = request.values;
    const Controls controls = controls_of(values_);
    if (controls.keyboard != sounding.keyboard()) {
      publish();
    } else {
      sounding.change(controls, request.start);
    }
  }
  if (request.kind == Request::Kind::play) {
    sounding.take(request.message, request.start);
  } else {
    sounding.attend();
  }
}

}  // namespace idiophone::plugin

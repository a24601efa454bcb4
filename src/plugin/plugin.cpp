#include "plugin.hpp"

#include <fmt/format.h>
#include <lv2/atom/util.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace idiophone::plugin {

namespace {

constexpr std::uint32_t rendered_at_once = 512;  // audio samples

}  // namespace

Plugin::Plugin(double rate, const LV2_Feature* const* features)
    : host_(features),
      uris_(host_),
      worker_(static_cast<int>(std::lround(rate))),
      request_(sizeof(Request) + longest_path),
      sound_(PlayedMaps::channels * rendered_at_once),
      shown_(map_slots) {
  lv2_atom_forge_init(&forge_, host_.map());
}

void Plugin::connect(std::uint32_t port, void* data) {
  switch (static_cast<Port>(port)) {
    case Port::events_in:
      events_in_ = static_cast<const LV2_Atom_Sequence*>(data);
      return;
    case Port::events_out:
      events_out_ = static_cast<LV2_Atom_Sequence*>(data);
      return;
    case Port::left:
    case Port::right:
      sound_out_.at(port - static_cast<std::uint32_t>(Port::left)) = static_cast<float*>(data);
      return;
    case Port::latency:
      latency_out_ = static_cast<float*>(data);
      return;
    case Port::controls:
      break;
  }
  const std::size_t control = port - static_cast<std::uint32_t>(Port::controls);
  if (control < controls_in_.size()) {
    controls_in_.at(control) = static_cast<const float*>(data);
  }
}

void Plugin::run(std::uint32_t frames) {
  sounding_ = worker_.newest();
  read_controls();
  read_events();
  send_changes(frames);
  render(frames);
  write_answers();
  if (latency_out_ != nullptr) {
    *latency_out_ = static_cast<float>(host_.latency());
  }
}

void Plugin::read_controls() {
  for (std::size_t control = 0; control < values_.size(); ++control) {
    if (controls_in_.at(control) != nullptr && !std::isnan(*controls_in_.at(control))) {
      values_.at(control) = *controls_in_.at(control);
    }
  }
}

void Plugin::read_events() {
  if (events_in_ == nullptr) {
    return;
  }
  const auto send_needed = [&](const Request& request, std::string_view path = {}) {
    lost_ += send(request, path) ? 0 : 1;
  };
  LV2_ATOM_SEQUENCE_FOREACH(events_in_, event) {
    const HostMessage message = read_message(event->body, uris_);
    Request request{.start = sounding_->stage().now() + event->time.frames + host_.latency()};
    if (const auto* note = std::get_if<drivers::MidiMessage>(&message)) {
      request.kind = Request::Kind::play;
      request.message = *note;
      send_needed(request);
    } else if (const auto* choice = std::get_if<MapChoice>(&message)) {
      request.kind = Request::Kind::load;
      request.slot = choice->slot;
      send_needed(request, choice->path);
    } else if (std::holds_alternative<MapQuestion>(message)) {
      request.kind = Request::Kind::tell;
      send_needed(request);
    }
  }
}

bool Plugin::send(Request request, std::string_view path) {
  request.values = values_;
  request.sounding = sounding_;
  request.lost = lost_;
  std::memcpy(request_.data(), &request, sizeof request);
  std::ranges::copy(path, request_.begin() + sizeof request);
  const bool is_sent = host_.schedule(request_.data(), sizeof request + path.size());
  if (is_sent) {
    lost_ = 0;
  }
  return is_sent;
}

/// Also without a change now and then, so that the worker frees what is done.
void Plugin::send_changes(std::uint32_t frames) {
  constexpr std::uint32_t longest_silence = 1024;
  since_request_ += frames;
  if ((values_ != sent_values_ || since_request_ >= longest_silence) &&
      send({.kind = Request::Kind::change, .start = sounding_->stage().now() + host_.latency()})) {
    sent_values_ = values_;
    since_request_ = 0;
  }
}

void Plugin::render(std::uint32_t frames) {
  const double full_scale = controls_of(values_).full_scale;
  for (std::uint32_t first = 0; first < frames; first += rendered_at_once) {
    const std::uint32_t count = std::min(rendered_at_once, frames - first);
    const std::span sound = std::span(sound_).first(PlayedMaps::channels * count);
    sounding_->stage().render(sound, 0);
    for (std::size_t channel = 0; channel < PlayedMaps::channels; ++channel) {
      for (std::uint32_t i = 0; i < count && sound_out_.at(channel) != nullptr; ++i) {
        sound_out_.at(channel)[first + i] = static_cast<float>(sound[PlayedMaps::channels * i + channel] / full_scale);
      }
    }
  }
}

void Plugin::take_answer(std::span<const char> answer) {
  std::size_t slot = 0;
  std::memcpy(&slot, answer.data(), sizeof slot);
  Shown& shown = shown_.at(slot);
  shown.size = answer.size() - sizeof slot;
  std::ranges::copy(answer.subspan(sizeof slot), shown.path.begin());
  shown.is_new = true;
}

void Plugin::write_answers() {
  if (events_out_ == nullptr) {
    return;
  }
  Answers answers(forge_, *events_out_, uris_);
  for (std::size_t slot = 0; slot < shown_.size(); ++slot) {
    Shown& shown = shown_[slot];
    if (shown.is_new && answers.add({.slot = slot, .path = {shown.path.data(), shown.size}})) {
      shown.is_new = false;
    }
  }
  answers.end();
}

void Plugin::work(std::span<const char> data, const std::function<bool(std::span<const char>)>& answer) {
  Request request;
  std::memcpy(&request, data.data(), sizeof request);
  if (request.lost > 0) {
    host_.tell_error(fmt::format("{} keys or maps are lost, because the host had no room for more work", request.lost));
  }
  try {
    if (request.kind == Request::Kind::load) {
      const std::span<const char> path = data.subspan(sizeof request);
      worker_.load(request.slot, {path.begin(), path.end()}, request.values);
    } else if (request.kind != Request::Kind::tell) {
      worker_.play(request);
    }
  } catch (const std::exception& error) {
    host_.tell_error(error.what());
  }
  if (request.kind == Request::Kind::load || request.kind == Request::Kind::tell) {
    const MapFiles files = worker_.files();
    for (std::size_t slot = 0; slot < map_slots; ++slot) {
      std::vector<char> text(sizeof slot);
      std::memcpy(text.data(), &slot, sizeof slot);
      text.insert(text.end(), files.at(slot).begin(), files.at(slot).end());
      answer(text);
    }
  }
}

namespace {

/// Paths as the host wants them in a project. Without its help they stay as they are.
class ProjectPaths {
 public:
  explicit ProjectPaths(const LV2_Feature* const* features)
      : map_(static_cast<LV2_State_Map_Path*>(feature_of(features, LV2_STATE__mapPath))),
        free_(static_cast<LV2_State_Free_Path*>(feature_of(features, LV2_STATE__freePath))) {}

  [[nodiscard]] std::string in_project(const std::string& path) const {
    return map_ == nullptr ? path : owned(map_->abstract_path(map_->handle, path.c_str()));
  }
  [[nodiscard]] std::string outside(const std::string& path) const {
    return map_ == nullptr ? path : owned(map_->absolute_path(map_->handle, path.c_str()));
  }

 private:
  [[nodiscard]] std::string owned(char* text) const {
    std::string copy = text == nullptr ? "" : text;
    if (free_ != nullptr) {
      free_->free_path(free_->handle, text);
    } else {
      std::free(text);  // as hosts did before there was this feature
    }
    return copy;
  }

  LV2_State_Map_Path* map_;
  LV2_State_Free_Path* free_;
};

}  // namespace

LV2_State_Status Plugin::save(LV2_State_Store_Function store, LV2_State_Handle handle,
                              const LV2_Feature* const* features) {
  const ProjectPaths paths(features);
  const MapFiles files = worker_.files();
  for (std::size_t slot = 0; slot < map_slots; ++slot) {
    if (files.at(slot).empty()) {
      continue;
    }
    const std::string path = paths.in_project(files.at(slot));
    const LV2_State_Status status = store(handle, uris_.maps.at(slot), path.c_str(), path.size() + 1, uris_.path,
                                          LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE);
    if (status != LV2_STATE_SUCCESS) {
      return status;
    }
  }
  return LV2_STATE_SUCCESS;
}

LV2_State_Status Plugin::restore(LV2_State_Retrieve_Function retrieve, LV2_State_Handle handle,
                                 const LV2_Feature* const* features) {
  const ProjectPaths paths(features);
  MapFiles files;
  for (std::size_t slot = 0; slot < map_slots; ++slot) {
    std::size_t size = 0;
    std::uint32_t type = 0, flags = 0;
    const void* value = retrieve(handle, uris_.maps.at(slot), &size, &type, &flags);
    if (value != nullptr && type == uris_.path && size > 0) {
      const std::string_view text(static_cast<const char*>(value), size);
      files.at(slot) = paths.outside(std::string(text.substr(0, text.find('\0'))));
    }
  }
  try {
    worker_.load_all(files);
  } catch (const std::exception& error) {
    host_.tell_error(error.what());  // the project keeps the names of files that are missing
  }
  return LV2_STATE_SUCCESS;
}

}  // namespace idiophone::plugin

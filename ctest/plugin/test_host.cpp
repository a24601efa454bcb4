#include "test_host.hpp"

#include <dlfcn.h>
#include <lv2/atom/util.h>
#include <lv2/buf-size/buf-size.h>
#include <lv2/midi/midi.h>
#include <lv2/patch/patch.h>

#include <cstdio>
#include <stdexcept>

#include "host_messages.hpp"
#include "strictness.hpp"

namespace idiophone::plugin {

namespace {

constexpr double host_rate = 48000.0;  // Hz

std::string map_uri_of(int slot) {
  return std::string(plugin_uri) + "#map" + std::to_string(slot);
}

}  // namespace

LV2_URID TestHost::map_uri(LV2_URID_Map_Handle self, const char* uri) {
  return static_cast<TestHost*>(self)->number(uri);
}

LV2_URID TestHost::number(const std::string& uri) {
  return numbers_.emplace(uri, static_cast<LV2_URID>(numbers_.size() + 1)).first->second;
}

LV2_Worker_Status TestHost::schedule(LV2_Worker_Schedule_Handle self, std::uint32_t size, const void* data) {
  const AudioThread::Host own_part;
  auto& host = *static_cast<TestHost*>(self);
  const auto* const bytes = static_cast<const char*>(data);
  const std::vector<char> request(bytes, bytes + size);
  if (host.work_ == Work::at_once) {
    host.work_on(request);
  } else {
    host.requests_.push_back(request);
  }
  return LV2_WORKER_SUCCESS;
}

LV2_Worker_Status TestHost::respond(LV2_Worker_Respond_Handle self, std::uint32_t size, const void* data) {
  const auto* const bytes = static_cast<const char*>(data);
  static_cast<TestHost*>(self)->responses_.emplace_back(bytes, bytes + size);
  return LV2_WORKER_SUCCESS;
}

int TestHost::print(LV2_Log_Handle self, LV2_URID /*type*/, const char* format, std::va_list arguments) {
  std::array<char, 1000> text{};
  const int size = std::vsnprintf(text.data(), text.size(), format, arguments);
  static_cast<TestHost*>(self)->log_text_ += text.data();
  return size;
}

int TestHost::print_some(LV2_Log_Handle self, LV2_URID type, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  const int size = print(self, type, format, arguments);
  va_end(arguments);
  return size;
}

TestHost::TestHost(Work work, std::int32_t block)
    : work_(work), block_(block), library_(dlopen(IDIOPHONE_PLUGIN, RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) {
    throw std::runtime_error(dlerror());
  }
  plugin_ = reinterpret_cast<LV2_Descriptor_Function>(dlsym(library_, "lv2_descriptor"))(0);
  std::array<LV2_Options_Option, 2> options = {{{LV2_OPTIONS_INSTANCE, 0, number(LV2_BUF_SIZE__nominalBlockLength),
                                                 sizeof block_, number(LV2_ATOM__Int), &block_},
                                                {}}};
  const std::array<LV2_Feature, 4> features = {{{LV2_URID__map, &map_},
                                                {LV2_WORKER__schedule, &schedule_},
                                                {LV2_LOG__log, &log_},
                                                {LV2_OPTIONS__options, options.data()}}};
  const std::array<const LV2_Feature*, 5> list = {&features[0], &features[1], &features[2], &features[3], nullptr};
  instance_ = plugin_->instantiate(plugin_, host_rate, "", list.data());
  if (instance_ == nullptr) {
    throw std::runtime_error("the plugin can't be made");
  }
  worker_ = static_cast<const LV2_Worker_Interface*>(plugin_->extension_data(LV2_WORKER__interface));
  state_ = static_cast<const LV2_State_Interface*>(plugin_->extension_data(LV2_STATE__interface));
  lv2_atom_forge_init(&forge_, &map_);
  begin_events();
}

TestHost::~TestHost() {
  plugin_->cleanup(instance_);
  dlclose(library_);
}

void TestHost::begin_events() {
  lv2_atom_forge_set_buffer(&forge_, events_in_.data(), events_in_.size());
  lv2_atom_forge_sequence_head(&forge_, &events_, 0);
}

void TestHost::send_midi(std::uint32_t frame, const std::array<unsigned char, 3>& bytes) {
  lv2_atom_forge_frame_time(&forge_, frame);
  lv2_atom_forge_atom(&forge_, 3, number(LV2_MIDI__MidiEvent));
  lv2_atom_forge_write(&forge_, bytes.data(), 3);
}

void TestHost::send_map(int slot, const std::string& path) {
  lv2_atom_forge_frame_time(&forge_, 0);
  lv2_atom_forge_object(&forge_, &object_, 0, number(LV2_PATCH__Set));
  lv2_atom_forge_key(&forge_, number(LV2_PATCH__property));
  lv2_atom_forge_urid(&forge_, number(map_uri_of(slot)));
  lv2_atom_forge_key(&forge_, number(LV2_PATCH__value));
  lv2_atom_forge_path(&forge_, path.c_str(), static_cast<std::uint32_t>(path.size()));
  lv2_atom_forge_pop(&forge_, &object_);
}

void TestHost::send_question() {
  lv2_atom_forge_frame_time(&forge_, 0);
  lv2_atom_forge_object(&forge_, &object_, 0, number(LV2_PATCH__Get));
  lv2_atom_forge_pop(&forge_, &object_);
}

std::vector<float> TestHost::run(std::uint32_t frames) {
  lv2_atom_forge_pop(&forge_, &events_);
  left_.assign(frames, 0.0F);
  right_.assign(frames, 0.0F);
  auto* const out = reinterpret_cast<LV2_Atom*>(events_out_.data());
  out->size = static_cast<std::uint32_t>(events_out_.size());
  std::vector<void*> data = {events_in_.data(), events_out_.data(), left_.data(), right_.data(), &latency_};
  for (float& control : controls) {
    data.push_back(&control);
  }
  for (std::uint32_t port = 0; port < data.size(); ++port) {
    plugin_->connect_port(instance_, port, data[port]);
  }
  {
    const AudioThread audio;
    plugin_->run(instance_, frames);
  }
  read_answers();
  work_through();
  begin_events();
  std::vector<float> sound;
  for (std::uint32_t i = 0; i < frames; ++i) {
    sound.push_back(left_[i]);
    sound.push_back(right_[i]);
  }
  return sound;
}

void TestHost::work_on(const std::vector<char>& request) {
  worker_->work(instance_, respond, this, static_cast<std::uint32_t>(request.size()), request.data());
}

void TestHost::work_through() {
  for (; !requests_.empty(); requests_.pop_front()) {
    work_on(requests_.front());
  }
  for (; !responses_.empty(); responses_.pop_front()) {
    const std::vector<char>& response = responses_.front();
    const AudioThread audio;
    worker_->work_response(instance_, static_cast<std::uint32_t>(response.size()), response.data());
  }
}

void TestHost::read_answers() {
  const auto* const events = reinterpret_cast<const LV2_Atom_Sequence*>(events_out_.data());
  LV2_ATOM_SEQUENCE_FOREACH(events, event) {
    const LV2_Atom *property = nullptr, *value = nullptr;
    lv2_atom_object_get(reinterpret_cast<const LV2_Atom_Object*>(&event->body), number(LV2_PATCH__property), &property,
                        number(LV2_PATCH__value), &value, 0);
    for (int slot = 1; slot <= static_cast<int>(map_slots); ++slot) {
      if (reinterpret_cast<const LV2_Atom_URID*>(property)->body == number(map_uri_of(slot))) {
        answers_[slot] = static_cast<const char*>(LV2_ATOM_BODY_CONST(value));
      }
    }
  }
}

namespace {

/// A project, while it is written or read.
struct OpenProject {
  Project project;
  const std::map<std::string, LV2_URID>* numbers;
  LV2_URID path;
};

LV2_State_Status store(LV2_State_Handle to, LV2_URID key, const void* value, std::size_t size, LV2_URID /*type*/,
                       std::uint32_t /*flags*/) {
  auto& open = *static_cast<OpenProject*>(to);
  for (const auto& [uri, number] : *open.numbers) {
    if (number == key) {
      open.project[uri] = {static_cast<const char*>(value), size};
    }
  }
  return LV2_STATE_SUCCESS;
}

const void* retrieve(LV2_State_Handle from, LV2_URID key, std::size_t* size, LV2_URID* type, std::uint32_t* flags) {
  const auto& open = *static_cast<const OpenProject*>(from);
  for (const auto& [uri, value] : open.project) {
    if (open.numbers->at(uri) == key) {
      *size = value.size();
      *type = open.path;
      *flags = LV2_STATE_IS_POD;
      return value.data();
    }
  }
  return nullptr;
}

}  // namespace

Project TestHost::save() const {
  OpenProject open{.project = {}, .numbers = &numbers_, .path = 0};
  state_->save(instance_, store, &open, 0, nullptr);
  return open.project;
}

void TestHost::restore(const Project& project) {
  OpenProject open{.project = project, .numbers = &numbers_, .path = number(LV2_ATOM__Path)};
  state_->restore(instance_, retrieve, &open, 0, nullptr);
}

}  // namespace idiophone::plugin

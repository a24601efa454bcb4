#pragma once
// One instance of the plugin: what a host calls.

#include <lv2/state/state.h>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "controls.hpp"
#include "host.hpp"
#include "host_messages.hpp"
#include "worker.hpp"

namespace idiophone::plugin {

/// The ports, as the bundle numbers them. The control ports follow.
enum class Port : std::uint32_t { events_in, events_out, left, right, latency, controls };

class Plugin {
 public:
  /// @param rate  audio samples per second
  /// @throws as Host
  Plugin(double rate, const LV2_Feature* const* features);

  /// @param data  of the host, as large as the port needs; read and written by run()
  void connect(std::uint32_t port, void* data);

  // The audio thread's part. It never locks, allocates or frees.

  void run(std::uint32_t frames);

  /// Takes what work() answers: a slot and the path of its map.
  void take_answer(std::span<const char> answer);

  // The worker thread's part.

  /// @param answer  hands an answer to take_answer(); false if the host has no room for it
  void work(std::span<const char> request, const std::function<bool(std::span<const char>)>& answer);

  // Of other threads.

  /// The paths of the maps go with the project. @param features  for paths
  LV2_State_Status save(LV2_State_Store_Function store, LV2_State_Handle handle, const LV2_Feature* const* features);
  LV2_State_Status restore(LV2_State_Retrieve_Function retrieve, LV2_State_Handle handle,
                           const LV2_Feature* const* features);

 private:
  struct Shown {
    std::array<char, longest_path> path{};
    std::size_t size = 0;
    bool is_new = false;
  };
  void read_controls();
  void read_events();
  bool send(Request request, std::string_view path = {});
  void send_changes(std::uint32_t frames);
  void render(std::uint32_t frames);
  void write_answers();

  Host host_;
  Uris uris_;
  Worker worker_;
  LV2_Atom_Forge forge_{};
  const LV2_Atom_Sequence* events_in_ = nullptr;
  LV2_Atom_Sequence* events_out_ = nullptr;
  std::array<float*, PlayedMaps::channels> sound_out_{};
  float* latency_out_ = nullptr;
  std::array<const float*, control_ports.size()> controls_in_{};
  // of the audio thread
  PlayedMaps* sounding_ = nullptr;
  ControlValues values_ = usual_values(), sent_values_ = usual_values();
  std::uint32_t since_request_ = 0;  // audio samples
  std::uint32_t lost_ = 0;           // requests that the host had no room for
  std::vector<char> request_;        // and a path
  std::vector<double> sound_;        // [samples x channels]
  std::vector<Shown> shown_;         // [slots]
};

}  // namespace idiophone::plugin

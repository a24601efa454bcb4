#pragma once
// A host for tests: it loads the plugin as music programs do, and its worker is a queue.

#include <lv2/atom/forge.h>
#include <lv2/core/lv2.h>
#include <lv2/log/log.h>
#include <lv2/options/options.h>
#include <lv2/state/state.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>

#include <array>
#include <cstdarg>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "controls.hpp"

namespace idiophone::plugin {

/// When the host does the work that the plugin asks for.
enum class Work { at_once, after_the_block };

/// What a project keeps of a plugin: values by the URIs of their keys.
using Project = std::map<std::string, std::string>;

class TestHost {
 public:
  /// @param block  audio samples that the host usually asks for at once
  TestHost(Work work, std::int32_t block);
  ~TestHost();
  TestHost(const TestHost&) = delete;
  TestHost(TestHost&&) = delete;
  TestHost& operator=(const TestHost&) = delete;
  TestHost& operator=(TestHost&&) = delete;

  /// For the next block. @param frame  audio sample in it
  void send_midi(std::uint32_t frame, const std::array<unsigned char, 3>& bytes);
  void send_map(int slot, const std::string& path);
  void send_question();

  /// The next audio samples: left, right, left, ... Offences are counted (strictness.hpp).
  std::vector<float> run(std::uint32_t frames);

  [[nodiscard]] Project save() const;
  void restore(const Project& project);

  ControlValues controls = usual_values();
  [[nodiscard]] int latency() const { return static_cast<int>(latency_); }
  [[nodiscard]] const std::string& log() const { return log_text_; }
  /// The paths of maps that the plugin answered, by slots.
  [[nodiscard]] const std::map<int, std::string>& answers() const { return answers_; }

 private:
  LV2_URID number(const std::string& uri);
  void begin_events();
  void work_through();
  void work_on(const std::vector<char>& request);
  void read_answers();

  static LV2_URID map_uri(LV2_URID_Map_Handle self, const char* uri);
  static LV2_Worker_Status schedule(LV2_Worker_Schedule_Handle self, std::uint32_t size, const void* data);
  static LV2_Worker_Status respond(LV2_Worker_Respond_Handle self, std::uint32_t size, const void* data);
  static int print(LV2_Log_Handle self, LV2_URID type, const char* format, std::va_list arguments);
  static int print_some(LV2_Log_Handle self, LV2_URID type, const char* format, ...);

  Work work_;
  std::int32_t block_;
  std::map<std::string, LV2_URID> numbers_;
  LV2_URID_Map map_{.handle = this, .map = map_uri};
  LV2_Worker_Schedule schedule_{.handle = this, .schedule_work = schedule};
  LV2_Log_Log log_{.handle = this, .printf = print_some, .vprintf = print};
  void* library_;
  const LV2_Descriptor* plugin_ = nullptr;
  LV2_Handle instance_ = nullptr;
  const LV2_Worker_Interface* worker_ = nullptr;
  const LV2_State_Interface* state_ = nullptr;
  std::deque<std::vector<char>> requests_, responses_;
  std::string log_text_;
  std::map<int, std::string> answers_;
  LV2_Atom_Forge forge_{};
  LV2_Atom_Forge_Frame events_{}, object_{};
  alignas(8) std::array<std::uint8_t, 65536> events_in_{}, events_out_{};
  std::vector<float> left_, right_;
  float latency_ = 0.0F;
};

}  // namespace idiophone::plugin

#pragma once
// What a host offers to the plugin: names as numbers, a worker thread, a log, and the length of its blocks.

#include <lv2/core/lv2.h>
#include <lv2/log/logger.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>

#include <cstdint>
#include <string>

namespace idiophone::plugin {

class Host {
 public:
  /// @throws std::runtime_error when it lacks a feature that the plugin needs
  explicit Host(const LV2_Feature* const* features);

  /// The number of a URI.
  [[nodiscard]] LV2_URID number(const char* uri) const { return map_->map(map_->handle, uri); }
  [[nodiscard]] LV2_URID_Map* map() const { return map_; }

  /// Audio samples by which blows begin later than their keys, so that the worker thread has a block's time to prepare
  /// them: a block, rounded up to whole blocks of resonators.
  [[nodiscard]] std::int64_t latency() const { return latency_; }

  /// Audio thread: asks for work. False if the host has no room for it.
  bool schedule(const void* data, std::size_t size) const;

  /// Not in the audio thread.
  void tell_error(const std::string& text);

 private:
  LV2_URID_Map* map_ = nullptr;
  LV2_Worker_Schedule* schedule_ = nullptr;
  LV2_Log_Logger log_{};
  std::int64_t latency_ = 0;
};

/// A feature of a host; null if it has not.
[[nodiscard]] void* feature_of(const LV2_Feature* const* features, const char* uri);

}  // namespace idiophone::plugin

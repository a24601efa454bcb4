#include "host.hpp"

#include <fmt/format.h>
#include <lv2/atom/atom.h>
#include <lv2/buf-size/buf-size.h>
#include <lv2/options/options.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::plugin {

namespace {

/// An option that is a whole number; none if the host has not.
std::optional<std::int32_t> option_of(const LV2_Options_Option* options, LV2_URID key, LV2_URID whole_number) {
  for (; options != nullptr && options->key != 0; ++options) {
    if (options->key == key && options->type == whole_number && options->value != nullptr) {
      return *static_cast<const std::int32_t*>(options->value);
    }
  }
  return {};
}

/// The usual block of a host, audio samples. Hosts that only know their longest one often ask for less.
std::int64_t block_of(const LV2_Options_Option* options, const LV2_URID_Map& map) {
  constexpr std::int32_t most = 1024;
  const auto number = [&](const char* uri) { return map.map(map.handle, uri); };
  const LV2_URID whole_number = number(LV2_ATOM__Int);
  const std::int32_t longest =
      std::min(option_of(options, number(LV2_BUF_SIZE__maxBlockLength), whole_number).value_or(most), most);
  return std::max(option_of(options, number(LV2_BUF_SIZE__nominalBlockLength), whole_number).value_or(longest), 1);
}

}  // namespace

void* feature_of(const LV2_Feature* const* features, const char* uri) {
  for (; features != nullptr && *features != nullptr; ++features) {
    if (std::strcmp((*features)->URI, uri) == 0) {
      return (*features)->data;
    }
  }
  return nullptr;
}

Host::Host(const LV2_Feature* const* features)
    : map_(static_cast<LV2_URID_Map*>(feature_of(features, LV2_URID__map))),
      schedule_(static_cast<LV2_Worker_Schedule*>(feature_of(features, LV2_WORKER__schedule))) {
  lv2_log_logger_init(&log_, map_, static_cast<LV2_Log_Log*>(feature_of(features, LV2_LOG__log)));
  if (map_ == nullptr || schedule_ == nullptr) {
    throw std::runtime_error(
        fmt::format("the host lacks the feature {}", map_ == nullptr ? LV2_URID__map : LV2_WORKER__schedule));
  }
  constexpr auto step = static_cast<std::int64_t>(resonators::ResonatorBank::most_samples);
  const auto* options = static_cast<const LV2_Options_Option*>(feature_of(features, LV2_OPTIONS__options));
  latency_ = (block_of(options, *map_) + step - 1) / step * step;
}

bool Host::schedule(const void* data, std::size_t size) const {
  return schedule_->schedule_work(schedule_->handle, static_cast<std::uint32_t>(size), data) == LV2_WORKER_SUCCESS;
}

void Host::tell_error(const std::string& text) {
  lv2_log_error(&log_, "Idiophone: %s\n", text.c_str());
}

}  // namespace idiophone::plugin

#include "idiophone/plugin/descriptor.hpp"

#include <lv2/state/state.h>
#include <lv2/worker/worker.h>

#include <exception>
#include <new>

#include "plugin.hpp"

namespace idiophone::plugin {

namespace {

Plugin& plugin_of(LV2_Handle handle) {
  return *static_cast<Plugin*>(handle);
}

std::span<const char> bytes_of(const void* data, std::uint32_t size) {
  return {static_cast<const char*>(data), size};
}

LV2_Handle instantiate(const LV2_Descriptor* /*descriptor*/, double rate, const char* /*bundle*/,
                       const LV2_Feature* const* features) {
  try {
    return new Plugin(rate, features);
  } catch (const std::exception&) {
    return nullptr;  // the host says that the plugin can't be made
  }
}

void connect_port(LV2_Handle handle, std::uint32_t port, void* data) {
  plugin_of(handle).connect(port, data);
}

void run(LV2_Handle handle, std::uint32_t frames) {
  plugin_of(handle).run(frames);
}

void clean_up(LV2_Handle handle) {
  delete static_cast<Plugin*>(handle);
}

LV2_Worker_Status work(LV2_Handle handle, LV2_Worker_Respond_Function respond, LV2_Worker_Respond_Handle to,
                       std::uint32_t size, const void* data) {
  try {
    plugin_of(handle).work(bytes_of(data, size), [&](std::span<const char> answer) {
      return respond(to, static_cast<std::uint32_t>(answer.size()), answer.data()) == LV2_WORKER_SUCCESS;
    });
    return LV2_WORKER_SUCCESS;
  } catch (const std::exception&) {
    return LV2_WORKER_ERR_UNKNOWN;
  }
}

LV2_Worker_Status work_response(LV2_Handle handle, std::uint32_t size, const void* data) {
  plugin_of(handle).take_answer(bytes_of(data, size));
  return LV2_WORKER_SUCCESS;
}

LV2_State_Status save(LV2_Handle handle, LV2_State_Store_Function store, LV2_State_Handle to, std::uint32_t /*flags*/,
                      const LV2_Feature* const* features) {
  try {
    return plugin_of(handle).save(store, to, features);
  } catch (const std::exception&) {
    return LV2_STATE_ERR_UNKNOWN;
  }
}

LV2_State_Status restore(LV2_Handle handle, LV2_State_Retrieve_Function retrieve, LV2_State_Handle from,
                         std::uint32_t /*flags*/, const LV2_Feature* const* features) {
  try {
    return plugin_of(handle).restore(retrieve, from, features);
  } catch (const std::exception&) {
    return LV2_STATE_ERR_UNKNOWN;
  }
}

const void* extension(const char* uri) {
  static constexpr LV2_Worker_Interface worker{.work = work, .work_response = work_response, .end_run = nullptr};
  static constexpr LV2_State_Interface state{.save = save, .restore = restore};
  if (std::string_view(uri) == LV2_WORKER__interface) {
    return &worker;
  }
  return std::string_view(uri) == LV2_STATE__interface ? &state : nullptr;
}

}  // namespace

const LV2_Descriptor& descriptor() {
  static constexpr LV2_Descriptor plugin{.URI = plugin_uri,
                                         .instantiate = instantiate,
                                         .connect_port = connect_port,
                                         .activate = nullptr,
                                         .run = run,
                                         .deactivate = nullptr,
                                         .cleanup = clean_up,
                                         .extension_data = extension};
  return plugin;
}

}  // namespace idiophone::plugin

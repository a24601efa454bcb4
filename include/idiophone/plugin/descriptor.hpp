#pragma once
// The LV2 plugin (lv2plug.in; docs/use/plugin.md).

#include <lv2/core/lv2.h>

namespace idiophone::plugin {

/// What a host calls.
[[nodiscard]] const LV2_Descriptor& descriptor();

}  // namespace idiophone::plugin

// The shared object of the LV2 plugin.

#include "idiophone/plugin/descriptor.hpp"

extern "C" LV2_SYMBOL_EXPORT const LV2_Descriptor* lv2_descriptor(uint32_t index) {
  return index == 0 ? &idiophone::plugin::descriptor() : nullptr;
}

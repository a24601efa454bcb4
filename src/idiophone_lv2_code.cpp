// The part of the LV2 plugin that needs the processor for which it was built. src/idiophone_lv2.cpp loads it.

#include "idiophone/plugin/descriptor.hpp"

extern "C" LV2_SYMBOL_EXPORT const LV2_Descriptor* idiophone_lv2_descriptor() {
  return &idiophone::plugin::descriptor();
}

// The shared object of the LV2 plugin that a host loads. It is compiled for any x86-64, so that it can refuse a
// processor that lacks instructions of the rest. The rest is a second shared object beside it.

#include <dlfcn.h>
#include <lv2/core/lv2.h>

#include <cstdio>
#include <string>

#include "missing_instructions.hpp"

namespace {

/// Null, after a message on the standard error, if the rest can't be loaded.
const LV2_Descriptor* descriptor_of_rest(const std::string& file) {
  void* const rest = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = rest == nullptr ? nullptr : ::dlsym(rest, "idiophone_lv2_descriptor");
  if (function == nullptr) {
    std::fprintf(stderr, "Idiophone: %s\n", ::dlerror());
    return nullptr;
  }
  return reinterpret_cast<const LV2_Descriptor* (*)()>(function)();
}

std::string folder_of_this_object() {
  static const char inside = 0;
  Dl_info info{};
  const std::string file = ::dladdr(&inside, &info) != 0 ? info.dli_fname : "";
  return file.substr(0, file.rfind('/') + 1);
}

}  // namespace

extern "C" LV2_SYMBOL_EXPORT const LV2_Descriptor* lv2_descriptor(uint32_t index) {
  static const LV2_Descriptor* const plugin =
      idiophone_lacks_instructions() ? nullptr : descriptor_of_rest(folder_of_this_object() + "idiophone_code.so");
  return index == 0 ? plugin : nullptr;
}

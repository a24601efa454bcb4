#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lv2/core/lv2.h>

#include "instruction_set.hpp"
#include "ranks.hpp"

namespace idiophone::plugin {

namespace {

bool has_all_instructions() {
#define IDIOPHONE_AND(number, name, macro) &&__builtin_cpu_supports(name) != 0
  return true IDIOPHONE_INSTRUCTIONS(IDIOPHONE_AND);
#undef IDIOPHONE_AND
}

}  // namespace

ON_RANKS(1);

/// The part that hosts load lies here without the rest.
TEST(PluginObject, SaysWhyItCannotBeLoaded) {
  void* const object = dlopen(IDIOPHONE_PLUGIN_FOR_ALL, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(object, nullptr) << dlerror();
  const auto describe = reinterpret_cast<LV2_Descriptor_Function>(dlsym(object, "lv2_descriptor"));
  ASSERT_NE(describe, nullptr);
  testing::internal::CaptureStderr();
  EXPECT_EQ(describe(0), nullptr);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::HasSubstr(has_all_instructions() ? "idiophone_code.so: cannot open"
                                                        : "instructions that this one lacks: "));
  dlclose(object);
}

}  // namespace idiophone::plugin

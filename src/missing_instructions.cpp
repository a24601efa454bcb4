// Compiled for any x86-64.

#include "missing_instructions.hpp"

#include <unistd.h>

#include <cstring>

#include "instruction_set.hpp"

namespace {

void say(const char* text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

/// Whether this processor has the instructions at this place in the list of instruction_set.hpp.
bool has(int place) {
  switch (place) {
#define IDIOPHONE_CASE(number, name, macro) \
  case number:                              \
    return __builtin_cpu_supports(name) != 0;
    IDIOPHONE_INSTRUCTIONS(IDIOPHONE_CASE)
#undef IDIOPHONE_CASE
    default:
      return true;
  }
}

const char* name_of(int place) {
  switch (place) {
#define IDIOPHONE_CASE(number, name, macro) \
  case number:                              \
    return name;
    IDIOPHONE_INSTRUCTIONS(IDIOPHONE_CASE)
#undef IDIOPHONE_CASE
    default:
      return "";
  }
}

}  // namespace

bool idiophone_lacks_instructions() {
  __builtin_cpu_init();
  bool is_missing = false;
  for (int place = 0; place < idiophone_instruction_count; ++place) {
    if ((idiophone_built_for >> place & 1U) != 0 && !has(place)) {
      say(is_missing ? ", " : "idiophone was built for processors with instructions that this one lacks: ");
      say(name_of(place));
      is_missing = true;
    }
  }
  if (is_missing) {
    say("; build it here, or with -DIDIOPHONE_ARCHITECTURE=x86-64-v3 (x86-64-v2, x86-64) for older processors\n");
  }
  return is_missing;
}

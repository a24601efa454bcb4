// Runs before all other code of a program, as it is compiled for any x86-64 and the rest is not. It ends the program
// with a message on a processor that lacks instructions that the rest was compiled for, and starts a program for a
// newer processor in its place, if one is installed and this processor can run it. It calls C functions alone, and so
// does missing_instructions.cpp: the linker could take a template or an inline function that is compiled here for the
// whole program.

#include <unistd.h>

#include <climits>
#include <cstdlib>
#include <cstring>

#include "missing_instructions.hpp"

namespace {

bool has_x86_64_v4() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

/// Starts ../libexec/idiophone/x86-64-v4/idiophone in place of this program. Returns if there is none.
void start_faster(char** arguments) {
  constexpr const char* faster = "../libexec/idiophone/x86-64-v4/idiophone";
  const char* chosen = std::getenv("IDIOPHONE_INSTRUCTION_SET");
  if (!has_x86_64_v4() || (chosen != nullptr && std::strcmp(chosen, "x86-64-v4") != 0)) {
    return;
  }
  char own[PATH_MAX] = {};
  if (::readlink("/proc/self/exe", own, sizeof own - 1) <= 0) {
    return;
  }
  char* const name = std::strrchr(own, '/') + 1;
  const std::size_t length = std::strlen(faster) + 1;
  if (name + length <= own + sizeof own) {
    std::memcpy(name, faster, length);
    ::execv(own, arguments);
  }
}

[[gnu::constructor(101)]] void choose_instruction_set(int /*count*/, char** arguments) {
  __builtin_cpu_init();
  start_faster(arguments);
  if (idiophone_lacks_instructions()) {
    ::_exit(1);
  }
}

}  // namespace

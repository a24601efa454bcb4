// Put before the C library by LD_PRELOAD: the machine seems to have MACHINE_BYTES of memory.

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>

#pragma GCC visibility push(default)  // it takes the place of the C library's

extern "C" long sysconf(int name) noexcept {
  static const auto real = reinterpret_cast<long (*)(int)>(dlsym(RTLD_NEXT, "sysconf"));
  return name == _SC_PHYS_PAGES ? std::atol(std::getenv("MACHINE_BYTES")) / real(_SC_PAGESIZE) : real(name);
}

#pragma GCC visibility pop

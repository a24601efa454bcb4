// Put before the C library by LD_PRELOAD: one call of one rank fails, as on a full disk or without memory, so that
// tests can fail each in turn. Calls count from the end of MPI_Init on. In the environment:
// - FAILING_RANK: the rank; 0 if omitted.
// - FAILING_FOLDER: calls that change files below this folder count; with FAILING_NAME only those whose path has it.
// - FAILING_BYTES: allocations of at least so many bytes count.
// - FAILING_CALL: which of them fails, from 1; 0 for none: the end tells how many there are, and which of them are the
//   first from their place: the program's own calls that lead to it.
// - FAILING_LASTING: "1" if all later ones fail as well.

#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <mpi.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <span>

#include <dlfcn.h>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

bool armed = false;
std::atomic<long> calls = 0;
const char* folder = nullptr;
const char* name_part = "";
std::size_t least_bytes = SIZE_MAX;
long failing = 0;
bool lasting = false;

long number(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atol(text) : otherwise;
}

constexpr std::size_t most_places = 10000;
std::mutex places_mutex;
std::array<std::size_t, most_places> places;  // hashes of stacks
std::array<long, most_places> first_calls;    // of each place
std::size_t place_count = 0;
thread_local bool looks_at_stack = false;  // may allocate

struct Code {
  std::uintptr_t begin = 0, end = 0;
};

/// Where the program itself is in memory, without its libraries.
Code code_of_program() {
  Code code;
  dl_iterate_phdr(
      [](dl_phdr_info* object, std::size_t, void* result) {  // the first object is the program
        for (const ElfW(Phdr) & part : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
          if (part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0) {
            const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr;
            *static_cast<Code*>(result) = {begin, begin + part.p_memsz};
          }
        }
        return 1;
      },
      &code);
  return code;
}

/// Where a call comes from: the program's own calls that lead to it.
std::size_t present_place() {
  static const Code code = code_of_program();
  std::array<void*, 100> stack;
  const int depth = backtrace(stack.data(), static_cast<int>(stack.size()));
  std::size_t place = 0;
  for (void* const call : std::span(stack.data(), static_cast<std::size_t>(depth))) {
    const auto address = reinterpret_cast<std::uintptr_t>(call);
    if (address >= code.begin && address < code.end) {
      place = 31 * place + address;
    }
  }
  return place;
}

void note_place(long call) {
  looks_at_stack = true;
  const std::size_t place = present_place();
  const std::lock_guard lock(places_mutex);
  const auto end = places.begin() + static_cast<std::ptrdiff_t>(place_count);
  if (std::find(places.begin(), end, place) == end) {
    if (place_count == most_places) {
      std::fputs("failing_calls: too many places\n", stderr);
      std::_Exit(1);
    }
    places[place_count] = place;
    first_calls[place_count++] = call;
  }
  looks_at_stack = false;
}

bool fails() {
  if (looks_at_stack) {
    return false;
  }
  const long call = ++calls;
  if (failing == 0) {
    note_place(call);
  }
  return failing > 0 && (call == failing || (lasting && call > failing));
}

bool allocation_fails(std::size_t bytes) {
  if (!armed || bytes < least_bytes || !fails()) {
    return false;
  }
  errno = ENOMEM;
  return true;
}

bool change_fails(const char* path) {
  if (!armed || folder == nullptr || std::strncmp(path, folder, std::strlen(folder)) != 0 ||
      std::strstr(path, name_part) == nullptr || !fails()) {
    return false;
  }
  errno = ENOSPC;
  return true;
}

bool change_fails(int file) {
  if (!armed || folder == nullptr) {
    return false;
  }
  std::array<char, 64> link{};
  std::array<char, PATH_MAX> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  return ::readlink(link.data(), path.data(), path.size() - 1) > 0 && change_fails(path.data());
}

bool writes(int flags) {
  return (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#pragma GCC visibility push(default)  // they take the place of the C library's

// FAILING(result, name, (parameters), (arguments), checked): a function whose call can fail by what it changes.
#define FAILING(result, name, parameters, arguments, checked)       \
  extern "C" result name parameters {                               \
    static auto* const original = next<result parameters>(#name);   \
    return change_fails(checked) ? result{-1} : original arguments; \
  }
// The same for a function that returns the system's reason.
#define FAILING_BY_REASON(name, parameters, arguments, checked) \
  extern "C" int name parameters {                              \
    static auto* const original = next<int parameters>(#name);  \
    return change_fails(checked) ? ENOSPC : original arguments; \
  }
#define FAILING_OPEN(name)                                                         \
  extern "C" int name(const char* path, int flags, ...) {                          \
    static auto* const original = next<int(const char*, int, ...)>(#name);         \
    va_list list;                                                                  \
    va_start(list, flags);                                                         \
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(list, mode_t) : 0;           \
    va_end(list);                                                                  \
    return writes(flags) && change_fails(path) ? -1 : original(path, flags, mode); \
  }

FAILING(ssize_t, write, (int file, const void* data, std::size_t size), (file, data, size), file)
FAILING(ssize_t, writev, (int file, const iovec* data, int count), (file, data, count), file)
FAILING(ssize_t, pwrite, (int file, const void* data, std::size_t size, off_t at), (file, data, size, at), file)
FAILING(ssize_t, pwrite64, (int file, const void* data, std::size_t size, off_t at), (file, data, size, at), file)
FAILING(ssize_t, pwritev, (int file, const iovec* data, int count, off_t at), (file, data, count, at), file)
FAILING(ssize_t, pwritev64, (int file, const iovec* data, int count, off_t at), (file, data, count, at), file)
FAILING(int, ftruncate, (int file, off_t size), (file, size), file)
FAILING(int, ftruncate64, (int file, off_t size), (file, size), file)
FAILING(int, fsync, (int file), (file), file)
FAILING(int, rename, (const char* from, const char* to), (from, to), to)
FAILING(int, mkdir, (const char* path, mode_t mode), (path, mode), path)
FAILING_BY_REASON(posix_fallocate, (int file, off_t at, off_t size), (file, at, size), file)
FAILING_BY_REASON(posix_fallocate64, (int file, off_t at, off_t size), (file, at, size), file)
FAILING_OPEN(open)
FAILING_OPEN(open64)

extern "C" void* malloc(std::size_t bytes) {
  return allocation_fails(bytes) ? nullptr : __libc_malloc(bytes);
}
extern "C" void* calloc(std::size_t count, std::size_t bytes) {
  return allocation_fails(count * bytes) ? nullptr : __libc_calloc(count, bytes);
}
extern "C" void* realloc(void* memory, std::size_t bytes) {
  return allocation_fails(bytes) ? nullptr : __libc_realloc(memory, bytes);
}
extern "C" void* memalign(std::size_t alignment, std::size_t bytes) {
  return allocation_fails(bytes) ? nullptr : __libc_memalign(alignment, bytes);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return memalign(alignment, bytes);
}
extern "C" int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  *memory = memalign(alignment, bytes);
  return *memory == nullptr ? ENOMEM : 0;
}

extern "C" int MPI_Init(int* count, char*** arguments) {
  const int status = PMPI_Init(count, arguments);
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  folder = std::getenv("FAILING_FOLDER");
  if (const char* part = std::getenv("FAILING_NAME"); part != nullptr) {
    name_part = part;
  }
  least_bytes = static_cast<std::size_t>(number("FAILING_BYTES", LONG_MAX));
  failing = number("FAILING_CALL", 0);
  lasting = number("FAILING_LASTING", 0) != 0;
  note_place(0);  // the first look at a stack loads a library
  place_count = 0;
  armed = rank == number("FAILING_RANK", 0);
  return status;
}

extern "C" int MPI_Finalize() {
  if (armed && failing == 0) {
    armed = false;
    std::printf("%ld calls can fail; the first from their places:", calls.load());
    for (std::size_t place = 0; place < place_count; ++place) {
      std::printf(" %ld", first_calls[place]);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return PMPI_Finalize();
}

#pragma GCC visibility pop

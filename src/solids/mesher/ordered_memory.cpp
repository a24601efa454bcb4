// Memory for gmsh's nodes, in the order in which they are made. gmsh hands nodes to its algorithm HXT sorted by their
// addresses, and HXT makes another mesh of another order. With malloc's addresses, which depend on all that was freed
// before and on the folder's name, the same file gave another mesh in every process.

#ifndef __SANITIZE_ADDRESS__  // which has an allocator of its own

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

// gmsh's nodes have 64 to 80 bytes. Other objects of such sizes may be among them, which does no harm.
constexpr std::size_t smallest = 49;
constexpr std::size_t largest = 96;
constexpr std::size_t reserved = std::size_t{1} << 40U;  // bytes of addresses, not of memory
constexpr std::size_t step = std::size_t{1} << 22U;

char* begin = nullptr;     // of the reserved addresses
char* next = nullptr;      // the first that is free
char* writable = nullptr;  // end of the part that has memory

bool is_ordered(const void* object) {
  const auto place = reinterpret_cast<std::uintptr_t>(object);
  const auto first = reinterpret_cast<std::uintptr_t>(begin);
  return begin != nullptr && place >= first && place < first + reserved;
}

/// Never freed, so that later nodes come after earlier ones.
void* ordered(std::size_t size) {
  constexpr std::size_t alignment = alignof(std::max_align_t);
  if (begin == nullptr) {
    void* found = mmap(nullptr, reserved, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (found == MAP_FAILED) {
      throw std::bad_alloc();
    }
    begin = next = writable = static_cast<char*>(found);
  }
  char* object = next;
  char* after = object + (size + alignment - 1) / alignment * alignment;
  if (after > writable) {
    if (writable + step > begin + reserved || mprotect(writable, step, PROT_READ | PROT_WRITE) != 0) {
      throw std::bad_alloc();
    }
    writable += step;
  }
  next = after;
  return object;
}

}  // namespace

void* operator new(std::size_t size) {
  if (size >= smallest && size <= largest) {
    return ordered(size);
  }
  void* object = std::malloc(std::max<std::size_t>(size, 1));
  if (object == nullptr) {
    throw std::bad_alloc();
  }
  return object;
}

void operator delete(void* object) noexcept {
  if (!is_ordered(object)) {
    std::free(object);
  }
}

void operator delete(void* object, std::size_t /*size*/) noexcept {
  operator delete(object);
}

#endif

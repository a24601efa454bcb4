#include "strictness.hpp"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <utility>

namespace {

constinit thread_local bool is_audio_thread = false;
constinit std::atomic<long> offences_of_all{0};

}  // namespace

// A sanitizer has functions of its own in these places.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

void note_offence() {
  offences_of_all += is_audio_thread ? 1 : 0;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

[[gnu::visibility("default")]] void* malloc(std::size_t size) {
  note_offence();
  return __libc_malloc(size);
}

[[gnu::visibility("default")]] void* calloc(std::size_t count, std::size_t size) {
  note_offence();
  return __libc_calloc(count, size);
}

[[gnu::visibility("default")]] void* realloc(void* memory, std::size_t size) {
  note_offence();
  return __libc_realloc(memory, size);
}

[[gnu::visibility("default")]] void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note_offence();
  return __libc_memalign(alignment, size);
}

[[gnu::visibility("default")]] int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  note_offence();
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

[[gnu::visibility("default")]] void free(void* memory) {
  note_offence();
  __libc_free(memory);
}

[[gnu::visibility("default")]] int pthread_mutex_lock(pthread_mutex_t* mutex) {
  note_offence();
  static const auto lock = reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  return lock(mutex);
}

}  // extern "C"

#endif

namespace idiophone::plugin {

AudioThread::AudioThread() {
  is_audio_thread = true;
}

AudioThread::~AudioThread() {
  is_audio_thread = false;
}

AudioThread::Host::Host() : before_(std::exchange(is_audio_thread, false)) {}

AudioThread::Host::~Host() {
  is_audio_thread = before_;
}

long AudioThread::offences() {
  return offences_of_all;
}

}  // namespace idiophone::plugin

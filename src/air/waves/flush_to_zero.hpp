#pragma once
// Waves die away into numbers so small that processors compute them slowly. Within this scope they count as zero.

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace idiophone::waves {

class FlushToZero {
 public:
#if defined(__SSE__)
  FlushToZero() {
    _mm_setcsr(before_ | zeros);
  }
  ~FlushToZero() {
    _mm_setcsr(before_);
  }
#else
  FlushToZero() = default;
  ~FlushToZero() = default;
#endif
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;
  FlushToZero(FlushToZero&&) = delete;
  FlushToZero& operator=(FlushToZero&&) = delete;

#if defined(__SSE__)
 private:
  static constexpr unsigned zeros = 0x8040;  // results, and operands
  unsigned before_ = _mm_getcsr();
#endif
};

}  // namespace idiophone::waves

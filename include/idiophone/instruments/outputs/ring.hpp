#pragma once
// A queue from one thread to one other, without locks.

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace idiophone::outputs {

/// One thread puts, one other takes. Neither waits or allocates.
template <class Item, std::size_t capacity>
class Ring {
 public:
  /// Leaves the item alone and returns false if the ring is full.
  bool put(Item& item) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == capacity) {
      return false;
    }
    items_[end % capacity] = std::move(item);
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// False if the ring is empty.
  bool take(Item& item) {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) {
      return false;
    }
    item = std::move(items_[begin % capacity]);
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t cache_line = 64;
  std::array<Item, capacity> items_{};
  alignas(cache_line) std::atomic<std::size_t> begin_{0};  // items taken so far
  alignas(cache_line) std::atomic<std::size_t> end_{0};    // items put so far
};

}  // namespace idiophone::outputs

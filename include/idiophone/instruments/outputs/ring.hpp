#pragma once
// A queue from one thread to one other, without locks.

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace idiophone::outputs {

/// One thread puts, one other takes. Neither waits or allocates.
template <class Item>
class Ring {
 public:
  /// @param capacity  items that it holds at once, at least one
  explicit Ring(std::size_t capacity) : items_(capacity) {}

  /// Leaves the item alone and returns false if the ring is full.
  bool put(Item& item) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == items_.size()) {
      return false;
    }
    items_[end % items_.size()] = std::move(item);
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// For the thread that puts: items that there is room for.
  [[nodiscard]] std::size_t room() const {
    return items_.size() - (end_.load(std::memory_order_relaxed) - begin_.load(std::memory_order_acquire));
  }

  /// For the thread that takes.
  [[nodiscard]] bool is_empty() const {
    return begin_.load(std::memory_order_relaxed) == end_.load(std::memory_order_acquire);
  }

  /// False if the ring is empty.
  bool take(Item& item) {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) {
      return false;
    }
    item = std::move(items_[begin % items_.size()]);
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t cache_line = 64;
  std::vector<Item> items_;
  alignas(cache_line) std::atomic<std::size_t> begin_{0};  // items taken so far
  alignas(cache_line) std::atomic<std::size_t> end_{0};    // items put so far
};

}  // namespace idiophone::outputs

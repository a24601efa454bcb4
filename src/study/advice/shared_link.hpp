#pragma once
// A link of a network whose bandwidth is shared by the messages that cross it at once.

#include <cstddef>
#include <queue>
#include <vector>

namespace idiophone::advice {

/// Of n messages at once, each gets an nth of the bandwidth. Times of successive calls never decrease.
template <class Message>
class SharedLink {
 public:
  /// bandwidth: bytes/s
  explicit SharedLink(double bandwidth) : bandwidth_(bandwidth) {}

  [[nodiscard]] bool empty() const { return crossing_.empty(); }

  /// A message of so many bytes begins to cross at a time, s.
  void enter(double time, double bytes, Message message) {
    if (!empty()) {
      carried_ += (time - time_) * bandwidth_ / count();
    }
    time_ = time;
    crossing_.push({carried_ + bytes, message});
  }

  /// When the next message has crossed if no other one enters before, s. Requires that the link is not empty.
  [[nodiscard]] double next_end() const { return time_ + (crossing_.top().end - carried_) * count() / bandwidth_; }

  /// The message of next_end(), which leaves.
  Message leave() {
    time_ = next_end();
    const Crossing first = crossing_.top();
    carried_ = first.end;
    crossing_.pop();
    return first.message;
  }

 private:
  struct Crossing {
    double end;  // what carried_ is when the message has crossed
    Message message;
    bool operator<(const Crossing& other) const { return end > other.end; }  // the queue has the largest first
  };
  [[nodiscard]] double count() const { return static_cast<double>(crossing_.size()); }

  double bandwidth_;
  double time_ = 0.0;     // of the last change, s
  double carried_ = 0.0;  // of a message that has crossed since the start, bytes
  std::priority_queue<Crossing> crossing_;
};

}  // namespace idiophone::advice

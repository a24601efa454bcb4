#pragma once
// Messages between hosts that share the bandwidth of these.

#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace idiophone::advice {

/// A host sends with its bandwidth, and receives with it at the same time. Of the messages that it sends at once, each
/// gets an equal part, and so does each that it receives; a message travels with the smaller of its two parts. Times of
/// successive calls never decrease.
class SharedNetwork {
 public:
  /// Which message, for the caller.
  struct Message {
    int receiver = 0, step = 0;
  };

  /// @param bandwidth  of a host, bytes/s
  SharedNetwork(int hosts, double bandwidth);

  /// A message of so many bytes leaves a host at a time, s.
  void enter(double time, int from, int to, double bytes, Message message);

  /// When the next message arrives if no other one leaves before, s; infinity if none is under way.
  [[nodiscard]] double next_end();

  /// The message of next_end(), which is finite.
  Message leave();

 private:
  struct Travelling {
    double end;  // what the way has carried of each message when this one arrives, bytes
    Message message;
    bool operator<(const Travelling& other) const { return end > other.end; }  // the queue has the largest first
  };
  /// From a host to another. All its messages have one rate.
  struct Way {
    int from, to;
    double rate = 0.0;     // bytes/s
    double carried = 0.0;  // of a message that travels since the start, bytes
    double time = 0.0;     // of `carried`, s
    int changes = 0;       // of what ends_ knows
    std::priority_queue<Travelling> messages;
  };
  struct End {
    double time;  // s
    int way, changes;
    bool operator<(const End& other) const { return time != other.time ? time > other.time : way > other.way; }
  };

  int way_of(int from, int to);
  static void settle(Way& way, double time);
  void schedule(int number);
  void share_again(double time, int from, int to);

  double bandwidth_;
  std::vector<int> sent_, received_;  // [hosts] messages that travel
  std::vector<Way> ways_;
  std::map<std::pair<int, int>, int> numbers_;         // of ways, by their hosts
  std::vector<std::vector<int>> ways_from_, ways_to_;  // [hosts]
  std::priority_queue<End> ends_;
};

}  // namespace idiophone::advice

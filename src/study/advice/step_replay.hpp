#pragma once
// Steps of ranks that wait for each other's messages, played one event after another.

#include <queue>
#include <vector>

#include "idiophone/study/advice/network.hpp"
#include "idiophone/study/advice/rank_steps.hpp"
#include "shared_network.hpp"

namespace idiophone::advice {

/// In each step, a rank computes what its messages need, sends one to each neighbour, computes the inner part, and
/// waits for the messages of all neighbours. In one of steps_per_full_wait steps, and always in shared memory, it waits
/// before the inner part. A message has an overhead at both ends, which is processor time. Messages between hosts share
/// the bandwidth of these.
class StepReplay {
 public:
  /// The steps must outlive it. Throws std::out_of_range for a sender that is no rank.
  StepReplay(const RankSteps& steps, const Network& network);

  /// When the last rank ends each of the first steps, s. [count] To be called once.
  [[nodiscard]] std::vector<double> ends(int count);

  /// The processor time of a rank in a step with the overheads of its messages, s.
  [[nodiscard]] double computing(int rank) const;

 private:
  struct Outgoing {
    int receiver;
    double bytes;
    bool is_near;  // both ranks are on one host
  };
  struct Rank {
    double overhead = 0.0;  // of its messages at one end, s
    std::vector<Outgoing> sent;
    int step = 0;
    bool is_waiting = false;
    std::vector<int> arrived;  // [steps] messages; a neighbour may be ahead
  };
  enum class Kind { send, wait, enter, arrive };
  struct Event {
    double time;  // s
    long order;   // in which events of one time were scheduled
    Kind kind;
    int rank;  // that sends, waits, or has sent the message
    SharedNetwork::Message message;
    double bytes;                               // of a message that leaves the host
    bool operator<(const Event& other) const {  // the queue has the largest first
      return time != other.time ? time > other.time : order > other.order;
    }
  };

  void schedule(double time, Kind kind, int rank, SharedNetwork::Message message = {}, double bytes = 0.0);
  void play(const Event& event);
  void start_step(int rank, double time);
  void send(int rank, double time);
  void arrive(SharedNetwork::Message message, double time);
  void end_step_if_ready(int rank, double time);
  [[nodiscard]] bool waits_at_once(int step) const;
  [[nodiscard]] int host_of(int rank) const { return rank / network_.ranks_on_host; }

  const RankSteps& steps_;
  Network network_;
  std::vector<Rank> ranks_;
  SharedNetwork between_hosts_;
  std::priority_queue<Event> events_;
  std::vector<double> ends_;
  long scheduled_ = 0;
};

}  // namespace idiophone::advice

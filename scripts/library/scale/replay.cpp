// replay: simulates steps of many ranks on a cluster with SimGrid, and prints how long a step of the second half takes,
// s.
//
// Reads numbers from standard input:
//   the cluster: ranks on a host; levels of switches; hosts on a switch; latency (s), overhead (s) and bandwidth
//     (bytes/s) of messages between hosts; the same three between ranks of a host
//   the steps: how many, at least two; steps_per_full_wait of `check --exchanges`
//   the ranks: how many; of each the seconds that it computes, those of them while messages travel, how many messages
//   it
//     receives, and of each the sender and the bytes
//
// A rank is an actor with a processor of its own. In each step it computes what its messages need, sends, computes the
// inner elements or cells, and waits for the messages of its neighbours. Overheads of messages are processor time.

// version.h of SimGrid 3 needs what s4u.hpp includes.
// clang-format off
#include <simgrid/s4u.hpp>
#include <simgrid/version.h>
// clang-format on

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace sg4 = simgrid::s4u;

namespace {

/// How messages travel. See include/idiophone/study/advice/network.hpp.
struct Network {
  double latency, overhead, bandwidth;
  [[nodiscard]] double wire() const { return latency - 2 * overhead; }
};

struct Cluster {
  int ranks_on_host, levels, hosts_on_switch;
  Network between_hosts, in_host;
};

struct Message {
  int sender;
  double bytes;
};

struct Rank {
  double computing, inner;
  std::vector<Message> received, sent;  // of those sent, `sender` is the rank that receives
};

struct Steps {
  int count, per_full_wait;
  std::vector<Rank> ranks;
};

template <class Number>
Number read() {
  Number number{};
  if (!(std::cin >> number)) {
    throw std::runtime_error("replay: a number is missing");
  }
  return number;
}

Network read_network() {
  const auto latency = read<double>();
  const auto overhead = read<double>();
  return {latency, overhead, read<double>()};
}

Steps read_steps() {
  Steps steps{.count = read<int>(), .per_full_wait = read<int>(), .ranks = {}};
  steps.ranks.resize(read<int>());
  for (std::size_t number = 0; number < steps.ranks.size(); ++number) {
    Rank& rank = steps.ranks[number];
    rank.computing = read<double>();
    rank.inner = read<double>();
    rank.received.resize(read<int>());
    for (Message& message : rank.received) {
      message.sender = read<int>();
      message.bytes = read<double>();
      steps.ranks.at(message.sender).sent.push_back({static_cast<int>(number), message.bytes});
    }
  }
  return steps;
}

/// Switches in a fat tree that carries all that its hosts can send; with one level, one switch.
struct Tree {
  unsigned levels;
  std::vector<unsigned> down, up, count;  // links of each level, as SimGrid counts them
};

Tree tree_of(const Cluster& cluster, unsigned hosts) {
  if (cluster.levels == 1) {
    return {1, {hosts}, {1}, {1}};
  }
  const auto below = static_cast<unsigned>(cluster.hosts_on_switch);
  return {2, {below, (hosts + below - 1) / below}, {1, below}, {1, 1}};
}

using Place = std::vector<unsigned long>;  // in the tree

std::string host_name(unsigned long number) {
  return "host" + std::to_string(number);
}

sg4::Link* as_memory(sg4::Link* link, const Network& network) {
  return link->set_sharing_policy(sg4::Link::SharingPolicy::FATPIPE)->set_latency(network.wire())->seal();
}

std::string memory_name(unsigned long number) {
  return "memory" + std::to_string(number);
}

constexpr double flops = 1e9;  // of a host; its ranks sleep while they compute
constexpr auto both_ways = sg4::Link::SharingPolicy::SPLITDUPLEX;

template <class Code>
sg4::ActorPtr start_actor(const std::string& name, sg4::Host* host, const Code& code) {
#if SIMGRID_VERSION >= 40000
  return sg4::Engine::get_instance()->add_actor(name, host, code);
#else
  return sg4::Actor::create(name, host, code);
#endif
}

#if SIMGRID_VERSION >= 40000  // it has a zone around all others, and other functions

void build(const Tree& tree, double bandwidth, double latency, const Network& in_host) {
  sg4::NetZone* zone = sg4::Engine::get_instance()->get_netzone_root()->add_netzone_fatTree(
      "cluster", tree.levels, tree.down, tree.up, tree.count, bandwidth, latency, both_ways);
  zone->set_host_cb([](sg4::NetZone* inside, const Place&, unsigned long number) {
    return inside->add_host(host_name(number), flops);
  });
  zone->set_loopback_cb([&](sg4::NetZone* inside, const Place&, unsigned long number) {
    return as_memory(inside->add_link(memory_name(number), in_host.bandwidth), in_host);
  });
  zone->seal();
}

#else

void build(const Tree& tree, double bandwidth, double latency, const Network& in_host) {
  const sg4::ClusterCallbacks callbacks(
      [](sg4::NetZone* zone, const Place&, unsigned long number) {
        return std::make_pair(zone->create_host(host_name(number), flops)->seal()->get_netpoint(),
                              static_cast<simgrid::kernel::routing::NetPoint*>(nullptr));
      },
      [&](sg4::NetZone* zone, const Place&, unsigned long number) {
        return as_memory(zone->create_link(memory_name(number), in_host.bandwidth), in_host);
      },
      {});
  sg4::create_fatTree_zone("cluster", nullptr, {tree.levels, tree.down, tree.up, tree.count}, callbacks, bandwidth,
                           latency, both_ways)
      ->seal();
}

#endif

/// Each message crosses two links for each level.
void build(const Cluster& cluster, unsigned hosts) {
  const Network& network = cluster.between_hosts;
  build(tree_of(cluster, hosts), network.bandwidth, network.wire() / (2 * cluster.levels), cluster.in_host);
}

sg4::Mailbox* mailbox(int sender, int receiver) {
  return sg4::Mailbox::by_name(std::to_string(sender) + ">" + std::to_string(receiver));
}

double half_time = 0.0;  // when the last rank has ended half of its steps, s

/// What one rank does.
class Actor {
 public:
  Actor(const Cluster& cluster, const Steps& steps, int number)
      : count_(steps.count), per_full_wait_(steps.per_full_wait), rank_(&steps.ranks[number]) {
    const auto is_near = [&](const Message& m) {
      return m.sender / cluster.ranks_on_host == number / cluster.ranks_on_host;
    };
    for (const Message& message : rank_->received) {
      overhead_ += (is_near(message) ? cluster.in_host : cluster.between_hosts).overhead;
      incoming_.push_back(mailbox(message.sender, number));
    }
    for (const Message& message : rank_->sent) {
      outgoing_.push_back(mailbox(number, message.sender));
    }
  }

  void operator()() {
    for (int step = 1; step <= count_; ++step) {
      sg4::this_actor::sleep_for(rank_->computing - rank_->inner + overhead_);  // of sending
      send();
      const bool waits_at_once = per_full_wait_ > 0 && step % per_full_wait_ == 0;
      if (!waits_at_once) {
        sg4::this_actor::sleep_for(rank_->inner);
      }
      receive();
      sg4::this_actor::sleep_for(overhead_ + (waits_at_once ? rank_->inner : 0.0));
      if (step == count_ / 2) {
        half_time = std::max(half_time, sg4::Engine::get_clock());
      }
    }
  }

  [[nodiscard]] const std::vector<sg4::Mailbox*>& incoming() const { return incoming_; }

 private:
  void send() {
    for (std::size_t i = 0; i < outgoing_.size(); ++i) {
      outgoing_[i]->put_init(&token_, static_cast<std::uint64_t>(rank_->sent[i].bytes))->detach();
    }
  }

  void receive() {
    for (sg4::Mailbox* from : incoming_) {
      from->get<int>();
    }
  }

  int count_, per_full_wait_;
  const Rank* rank_;
  double overhead_ = 0.0;  // of all messages at one end, s
  std::vector<sg4::Mailbox*> incoming_, outgoing_;
  static inline int token_ = 0;  // messages have a size and no content
};

void start(const Cluster& cluster, const Steps& steps) {
  for (std::size_t number = 0; number < steps.ranks.size(); ++number) {
    const Actor actor(cluster, steps, static_cast<int>(number));
    sg4::Host* host = sg4::Host::by_name(host_name(number / cluster.ranks_on_host));
    const sg4::ActorPtr started = start_actor("rank" + std::to_string(number), host, actor);
    for (sg4::Mailbox* box : actor.incoming()) {
      box->set_receiver(started);  // messages leave when they are sent, though the rank does not wait for them yet
    }
  }
}

/// How long the second half of the steps takes, s. The first one forgets that all ranks begin at once.
double simulated(const Cluster& cluster, const Steps& steps) {
  build(cluster, (steps.ranks.size() + cluster.ranks_on_host - 1) / cluster.ranks_on_host);
  start(cluster, steps);
  sg4::Engine::get_instance()->run();
  return sg4::Engine::get_clock() - half_time;
}

}  // namespace

int main(int count, char** words) {
  sg4::Engine engine(&count, words);
  engine.set_config("network/model:CM02");
  engine.set_config("network/crosstraffic:0");
  const Cluster cluster{.ranks_on_host = read<int>(),
                        .levels = read<int>(),
                        .hosts_on_switch = read<int>(),
                        .between_hosts = read_network(),
                        .in_host = read_network()};
  const Steps steps = read_steps();
  std::cout << simulated(cluster, steps) / (steps.count - steps.count / 2) << std::endl;
}

// forwarder LATENCY BANDWIDTH HOST=ADDRESS ...: the network between the hosts of network.py, with a latency (s) and a
// bandwidth of each host (bytes/s). It makes a TUN device eth0 in the network namespace of each host, reads what the
// host sends there, and writes it to the device of the host that has the address, when it is due. It needs root, and
// runs at real-time priority, so that it is punctual beside ranks that compute. It prints a line when it is ready, and
// ends when its standard input ends.

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <netinet/ip.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

constexpr int largest_packet = 65000;                 // bytes: most messages are one packet, so that few are handled
constexpr auto awake = std::chrono::microseconds(5);  // a sleep of the kernel ends late by about so much
constexpr auto longest_sleep = std::chrono::seconds(1);

void require(bool fine, const std::string& what) {
  if (!fine) {
    throw std::system_error(errno, std::generic_category(), what);
  }
}

nanoseconds to_time(double seconds) {
  return std::chrono::duration_cast<nanoseconds>(std::chrono::duration<double>(seconds));
}

struct Packet {
  Clock::time_point due;
  std::vector<char> bytes;
};

struct Host {
  int device;
  in_addr_t address;
  Clock::time_point is_free;    // when all that the host has sent so far has left it
  std::deque<Packet> arriving;  // ascending times
};

Host connect(const std::string& name, const std::string& address) {
  const int space = open(("/run/netns/" + name).c_str(), O_RDONLY | O_CLOEXEC);
  require(space >= 0 && setns(space, CLONE_NEWNET) == 0, name);
  close(space);
  const int device = open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  std::strcpy(request.ifr_name, "eth0");
  require(device >= 0 && ioctl(device, TUNSETIFF, &request) == 0, "/dev/net/tun");
  const int any = socket(AF_INET, SOCK_DGRAM, 0);
  request.ifr_mtu = largest_packet;
  require(any >= 0 && ioctl(any, SIOCSIFMTU, &request) == 0, "size of packets");
  close(any);
  return {.device = device, .address = inet_addr(address.c_str()), .is_free = {}, .arriving = {}};
}

class Network {
 public:
  Network(double latency, double bandwidth, std::vector<Host> hosts)
      : latency_(to_time(latency)), bandwidth_(bandwidth), hosts_(std::move(hosts)), buffer_(largest_packet) {}

  /// Until the standard input ends.
  void forward() {
    std::vector<pollfd> watched = {{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0}};
    for (const Host& host : hosts_) {
      watched.push_back({.fd = host.device, .events = POLLIN, .revents = 0});
    }
    while (watched[0].revents == 0) {
      for (Host& host : hosts_) {
        take(host);
        deliver(host);
      }
      const timespec sleep{.tv_sec = 0, .tv_nsec = std::min<long>(time_to_sleep().count(), 999'999'999)};
      ppoll(watched.data(), watched.size(), &sleep, nullptr);
    }
  }

 private:
  /// What a host has sent.
  void take(Host& from) {
    for (ssize_t size = 0; (size = read(from.device, buffer_.data(), buffer_.size())) > 0;) {
      iphdr header{};
      std::memcpy(&header, buffer_.data(), sizeof(header));
      const auto to = std::ranges::find(hosts_, header.daddr, &Host::address);
      if (to != hosts_.end()) {  // others are broadcasts of the kernel, which nobody needs
        from.is_free = std::max(from.is_free, Clock::now()) + to_time(static_cast<double>(size) / bandwidth_);
        to->arriving.push_back({from.is_free + latency_, {buffer_.begin(), buffer_.begin() + size}});
      }
    }
  }

  static void deliver(Host& to) {
    for (; !to.arriving.empty() && to.arriving.front().due <= Clock::now(); to.arriving.pop_front()) {
      const std::vector<char>& bytes = to.arriving.front().bytes;
      require(write(to.device, bytes.data(), bytes.size()) >= 0, "a packet is lost");
    }
  }

  [[nodiscard]] nanoseconds time_to_sleep() const {
    nanoseconds shortest = longest_sleep;
    for (const Host& host : hosts_) {
      if (!host.arriving.empty()) {
        shortest = std::min<nanoseconds>(shortest, host.arriving.front().due - Clock::now() - awake);
      }
    }
    return std::max(shortest, nanoseconds(0));
  }

  nanoseconds latency_;
  double bandwidth_;
  std::vector<Host> hosts_;
  std::vector<char> buffer_;
};

}  // namespace

int main(int count, char** words) try {
  if (count < 4) {
    std::cerr << "usage: forwarder LATENCY BANDWIDTH HOST=ADDRESS ...\n";
    return 1;
  }
  std::vector<Host> hosts;
  for (int i = 3; i < count; ++i) {
    const std::string word = words[i];
    const std::size_t sign = word.find('=');
    hosts.push_back(connect(word.substr(0, sign), word.substr(sign + 1)));
  }
  const sched_param priority{.sched_priority = 50};  // above that of the ranks
  require(sched_setscheduler(0, SCHED_FIFO, &priority) == 0, "real-time priority");
  std::cout << "ready" << std::endl;
  Network(std::stod(words[1]), std::stod(words[2]), std::move(hosts)).forward();
  return 0;
} catch (const std::exception& error) {
  std::cerr << "forwarder: " << error.what() << '\n';
  return 1;
}

#pragma once
// A UDP port of this machine that hears datagrams.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone::drivers {

class UdpPort {
 public:
  /// @param address  of this machine, as a number: 127.0.0.1 hears this machine only, 0.0.0.0 all networks
  /// @param port     0 takes any free one
  /// @throws std::runtime_error when it can't be used
  UdpPort(const std::string& address, int port);
  ~UdpPort();
  UdpPort(const UdpPort&) = delete;
  UdpPort(UdpPort&&) = delete;
  UdpPort& operator=(const UdpPort&) = delete;
  UdpPort& operator=(UdpPort&&) = delete;

  /// The next datagram that has come in, without waiting; none if there is none. Valid until the next call.
  [[nodiscard]] std::optional<std::span<char>> receive();

  [[nodiscard]] int port() const { return port_; }

 private:
  int socket_ = -1;
  int port_ = 0;
  std::vector<char> datagram_;
};

}  // namespace idiophone::drivers

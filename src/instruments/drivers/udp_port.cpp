#include "udp_port.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace idiophone::drivers {

namespace {

constexpr std::size_t longest_datagram = 65536;

using Addresses = std::unique_ptr<addrinfo, void (*)(addrinfo*)>;

Addresses addresses_of(const std::string& address, int port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_NUMERICHOST | AI_PASSIVE;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(address.c_str(), std::to_string(port).c_str(), &hints, &found); error != 0) {
    throw std::runtime_error(
        fmt::format("UDP: '{}' is no address such as 127.0.0.1: {}", address, gai_strerror(error)));
  }
  return {found, &freeaddrinfo};
}

int port_of(int socket) {
  sockaddr_storage own{};
  socklen_t size = sizeof own;
  getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(own).sin6_port
                                         : reinterpret_cast<sockaddr_in&>(own).sin_port);
}

}  // namespace

UdpPort::UdpPort(const std::string& address, int port) : datagram_(longest_datagram) {
  const Addresses addresses = addresses_of(address, port);
  socket_ = socket(addresses->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0 || bind(socket_, addresses->ai_addr, addresses->ai_addrlen) != 0) {
    const int error = errno;
    if (socket_ >= 0) {
      close(socket_);
    }
    throw std::runtime_error(fmt::format("UDP port {} can't be used on {}: {}", port, address, std::strerror(error)));
  }
  port_ = port_of(socket_);
}

UdpPort::~UdpPort() {
  close(socket_);
}

std::optional<std::span<char>> UdpPort::receive() {
  const ssize_t size = recv(socket_, datagram_.data(), datagram_.size(), 0);
  return size < 0 ? std::nullopt : std::optional(std::span(datagram_).first(static_cast<std::size_t>(size)));
}

}  // namespace idiophone::drivers

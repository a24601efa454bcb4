#include "osc_packet.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <lo/lo.h>
#include <lo/lo_lowlevel.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace idiophone::drivers {

namespace {

constexpr std::string_view bundle_name("#bundle\0", 8);
constexpr std::size_t bundle_head = 16;  // bytes: its name and its time
constexpr int most_messages = 100;       // in a packet
constexpr int deepest = 8;               // bundle in a bundle

OscArguments texts(const char* types, lo_arg** values, int count) {
  OscArguments arguments;
  for (int i = 0; i < count; ++i) {
    const auto type = static_cast<lo_type>(types[i]);
    if (lo_is_string_type(type) != 0) {
      arguments.emplace_back(reinterpret_cast<const char*>(values[i]));  // lo_arg would need an alignment that it lacks
    } else if (lo_is_numerical_type(type) != 0) {
      arguments.push_back(fmt::format("{}", static_cast<double>(lo_hires_val(type, values[i]))));
    } else {
      throw std::runtime_error(fmt::format("argument {} is no number or text", i + 1));
    }
  }
  return arguments;
}

class PacketReader {
 public:
  explicit PacketReader(const std::function<void(const std::string&, const OscArguments&)>& handle) : handle_(handle) {}

  void read(std::span<char> packet, int depth = 0) {
    if (std::string_view(packet.data(), packet.size()).starts_with(bundle_name)) {
      read_bundle(packet, depth);
      return;
    }
    if (++messages_ > most_messages) {
      throw std::runtime_error(
          fmt::format("a bundle has more than {} messages; the others are left out", most_messages));
    }
    int error = 0;
    const std::unique_ptr<std::remove_pointer_t<lo_message>, void (*)(lo_message)> message(
        lo_message_deserialise(packet.data(), packet.size(), &error), &lo_message_free);
    if (!message) {
      throw std::runtime_error("a packet is no OSC message");
    }
    const std::string path = lo_get_path(packet.data(), static_cast<ssize_t>(packet.size()));
    handle_(path, texts(lo_message_get_types(message.get()), lo_message_get_argv(message.get()),
                        lo_message_get_argc(message.get())));
  }

 private:
  void read_bundle(std::span<char> bundle, int depth) {
    for (std::size_t place = bundle_head; place < bundle.size();) {
      std::uint32_t size = 0;
      if (depth == deepest || bundle.size() - place < sizeof size) {
        throw std::runtime_error("a bundle is damaged");
      }
      std::memcpy(&size, &bundle[place], sizeof size);
      size = ntohl(size);
      place += sizeof size;
      if (size == 0 || size > bundle.size() - place) {
        throw std::runtime_error("a bundle is damaged");
      }
      read(bundle.subspan(place, size), depth + 1);
      place += size;
    }
  }

  const std::function<void(const std::string&, const OscArguments&)>& handle_;
  int messages_ = 0;
};

}  // namespace

void read_osc_packet(std::span<char> packet,
                     const std::function<void(const std::string& path, const OscArguments& arguments)>& handle) {
  PacketReader(handle).read(packet);
}

}  // namespace idiophone::drivers

#include "idiophone/instruments/drivers/osc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <span>
#include <stdexcept>

#include "idiophone/instruments/drivers/few_warnings.hpp"
#include "osc_packet.hpp"
#include "udp_port.hpp"

namespace idiophone::drivers {

namespace {

/// The events of addresses in YAML, with a $ for each argument.
const std::map<std::string, std::string>& layouts() {
  static const std::map<std::string, std::string> all = [] {
    const std::string contact =
        "body: $, from: [$, $, $], to: [$, $, $], direction: [$, $, $], speed: $, load: $, mass: $, hardness: $, "
        "size: $, roughness: {height: $}";
    const std::string scrape = "{type: scrape, " + contact + ", friction: $}", roll = "{type: roll, " + contact + "}";
    const std::string bow =
        "{type: bow, body: $, at: [$, $, $], direction: [$, $, $], speed: $, load: $, "
        "friction: {sticking: $, sliding: $}";
    return std::map<std::string, std::string>{
        {"/blow", "{type: blow, body: $, at: [$, $, $], direction: [$, $, $], mass: $, hardness: $, speed: $}"},
        {"/scrape", scrape},
        {"/scrape/begin", scrape},
        {"/roll", roll},
        {"/roll/begin", roll},
        {"/bow", bow + ", duration: $}"},
        {"/bow/begin", bow + "}"},
        {"/tune", "{type: tune, body: $, size: $, friction: $}"}};
  }();
  return all;
}

double number_of(const std::string& text, const char* what) {
  try {
    return std::stod(text);
  } catch (const std::logic_error&) {
    throw std::runtime_error(fmt::format("the {} is no number: '{}'", what, text));
  }
}

void require_count(const OscArguments& arguments, std::size_t needed) {
  if (arguments.size() != needed) {
    throw std::runtime_error(fmt::format("needs {} arguments, found {}", needed, arguments.size()));
  }
}

Vector3 place_of(const OscArguments& arguments) {
  if (arguments.size() != 3) {
    throw std::runtime_error(
        fmt::format("needs the three coordinates of a place, found {} arguments", arguments.size()));
  }
  Vector3 place;
  for (Eigen::Index i = 0; i < 3; ++i) {
    place[i] = number_of(arguments[static_cast<std::size_t>(i)], "coordinate");
  }
  if (!place.allFinite()) {
    throw std::runtime_error("the place is not finite");
  }
  return place;
}

}  // namespace

struct OscServer::State {
  State(const std::string& address, int number, std::vector<std::string> names, OscActions wanted)
      : port(address, number), bodies(std::move(names)), actions(std::move(wanted)) {}

  UdpPort port;
  std::vector<std::string> bodies;
  OscActions actions;
  FewWarnings warnings;

  [[nodiscard]] score::ScoreEvent event(const std::string& address, const OscArguments& arguments) const {
    return score::read_event(event_text(address, arguments), fmt::format("OSC {}", address), bodies);
  }

  void act(const std::string& path, const OscArguments& arguments) const {
    if (path == "/listener") {
      actions.move_listener(place_of(arguments));
    } else if (path.ends_with("/begin")) {
      if (arguments.empty()) {
        throw std::runtime_error("needs the name of the stroke first");
      }
      actions.begin_stroke(arguments.front(), event(path, {arguments.begin() + 1, arguments.end()}));
    } else if (path == "/stroke/change") {
      require_count(arguments, 3);
      actions.change_stroke(arguments[0], number_of(arguments[1], "speed"), number_of(arguments[2], "load"));
    } else if (path == "/stroke/end") {
      require_count(arguments, 1);
      actions.end_stroke(arguments[0]);
    } else {
      actions.play(event(path, arguments));
    }
  }

  void handle(std::span<char> packet) {
    try {
      read_osc_packet(packet, [&](const std::string& path, const OscArguments& arguments) {
        try {
          act(path, arguments);
        } catch (const std::exception& error) {
          warnings.warn(fmt::format("OSC {}: {}", path, error.what()));
        }
      });
    } catch (const std::exception& error) {
      warnings.warn(fmt::format("OSC: {}", error.what()));
    }
  }
};

std::string event_text(const std::string& address, const OscArguments& arguments) {
  if (address == "/event" && arguments.size() == 1) {
    return arguments.front();
  }
  const auto found = layouts().find(address);
  if (found == layouts().end()) {
    throw std::runtime_error(
        "unknown address or arguments; there are /blow, /scrape, /roll, /bow, /tune, /event, /listener, "
        "/scrape/begin, /roll/begin, /bow/begin, /stroke/change, /stroke/end");
  }
  const std::string& layout = found->second;
  require_count(arguments, static_cast<std::size_t>(std::ranges::count(layout, '$')));
  std::string text;
  auto next = arguments.begin();
  for (const char letter : layout) {
    text += letter == '$' ? *next++ : std::string(1, letter);
  }
  return text;
}

OscServer::OscServer(const std::string& address, int port, std::vector<std::string> bodies, OscActions actions)
    : state_(std::make_unique<State>(address, port, std::move(bodies), std::move(actions))) {}

OscServer::~OscServer() = default;

void OscServer::poll() {
  constexpr auto longest = std::chrono::milliseconds(10);
  const auto end = std::chrono::steady_clock::now() + longest;
  for (std::size_t i = 0; i < most_packets && std::chrono::steady_clock::now() < end; ++i) {
    const std::optional<std::span<char>> packet = state_->port.receive();
    if (!packet) {
      return;
    }
    state_->handle(*packet);
  }
}

int OscServer::port() const {
  return state_->port.port();
}

std::size_t OscServer::refused() const {
  return state_->warnings.count();
}

}  // namespace idiophone::drivers

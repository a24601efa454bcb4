#include "idiophone/instruments/drivers/osc.hpp"

#include <fmt/format.h>
#include <lo/lo.h>
#include <spdlog/spdlog.h>

#include <map>
#include <span>
#include <stdexcept>

namespace idiophone::drivers {

namespace {

/// A key of an event, and how many numbers it has: 1, or 3 for a list.
struct OscKey {
  const char* name;
  std::size_t count;
};

const std::map<std::string, std::vector<OscKey>>& layouts() {
  static const std::map<std::string, std::vector<OscKey>> all = [] {
    const std::vector<OscKey> roll = {{"body", 1}, {"from", 3}, {"to", 3},       {"direction", 3}, {"speed", 1},
                                      {"load", 1}, {"mass", 1}, {"hardness", 1}, {"size", 1},      {"roughness", 1}};
    std::vector<OscKey> scrape = roll;
    scrape.push_back({"friction", 1});
    return std::map<std::string, std::vector<OscKey>>{
        {"/blow", {{"body", 1}, {"at", 3}, {"direction", 3}, {"mass", 1}, {"hardness", 1}, {"speed", 1}}},
        {"/scrape", scrape},
        {"/roll", roll},
        {"/tune", {{"body", 1}, {"size", 1}, {"friction", 1}}}};
  }();
  return all;
}

OscArguments texts(const char* types, lo_arg** values, int count) {
  OscArguments arguments;
  for (int i = 0; i < count; ++i) {
    const auto type = static_cast<lo_type>(types[i]);
    if (lo_is_string_type(type) != 0) {
      arguments.emplace_back(&values[i]->s);
    } else if (lo_is_numerical_type(type) != 0) {
      arguments.push_back(fmt::format("{}", static_cast<double>(lo_hires_val(type, values[i]))));
    } else {
      throw std::runtime_error(fmt::format("argument {} is no number or text", i + 1));
    }
  }
  return arguments;
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
  lo_server server = nullptr;
  std::vector<std::string> bodies;
  OscActions actions;
  std::size_t refused = 0;

  [[nodiscard]] score::ScoreEvent event(const std::string& address, const OscArguments& arguments) const {
    return score::read_event(event_text(address, arguments), fmt::format("OSC {}", address), bodies);
  }

  void act(const std::string& path, const OscArguments& arguments) const {
    if (path == "/listener") {
      actions.move_listener(place_of(arguments));
    } else if (path == "/scrape/begin" || path == "/roll/begin") {
      if (arguments.empty()) {
        throw std::runtime_error("needs the name of the stroke first");
      }
      actions.begin_stroke(arguments.front(),
                           event(path.substr(0, path.rfind('/')), {arguments.begin() + 1, arguments.end()}));
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

  /// No exception may leave it, because liblo is C.
  static int handle(const char* path, const char* types, lo_arg** values, int count, lo_message /*message*/,
                    void* self) {
    auto& state = *static_cast<State*>(self);
    try {
      state.act(path, texts(types, values, count));
    } catch (const std::exception& error) {
      ++state.refused;
      spdlog::warn("OSC {}: {}", path, error.what());
    }
    return 0;
  }
};

std::string event_text(const std::string& address, const OscArguments& arguments) {
  if (address == "/event" && arguments.size() == 1) {
    return arguments.front();
  }
  const auto found = layouts().find(address);
  if (found == layouts().end()) {
    throw std::runtime_error(
        "unknown address or arguments; there are /blow, /scrape, /roll, /tune, /event, /listener, /scrape/begin, "
        "/roll/begin, /stroke/change, /stroke/end");
  }
  std::size_t needed = 0;
  for (const OscKey& key : found->second) {
    needed += key.count;
  }
  require_count(arguments, needed);
  std::string text = "{type: " + address.substr(1);
  auto next = arguments.begin();
  for (const OscKey& key : found->second) {
    if (key.count == 3) {
      text += fmt::format(", {}: [{}, {}, {}]", key.name, next[0], next[1], next[2]);
    } else {
      const bool is_height = std::string_view(key.name) == "roughness";
      text += fmt::format(fmt::runtime(is_height ? ", {}: {{height: {}}}" : ", {}: {}"), key.name, *next);
    }
    next += static_cast<std::ptrdiff_t>(key.count);
  }
  return text + "}";
}

OscServer::OscServer(int port, std::vector<std::string> bodies, OscActions actions)
    : state_(std::make_unique<State>()) {
  state_->bodies = std::move(bodies);
  state_->actions = std::move(actions);
  const std::string wanted = std::to_string(port);
  state_->server = lo_server_new_with_proto(port == 0 ? nullptr : wanted.c_str(), LO_UDP, nullptr);
  if (state_->server == nullptr) {
    throw std::runtime_error(fmt::format("OSC: UDP port {} can't be used; is another program using it?", port));
  }
  lo_server_add_method(state_->server, nullptr, nullptr, &State::handle, state_.get());
}

OscServer::~OscServer() {
  lo_server_free(state_->server);
}

void OscServer::poll() {
  while (lo_server_recv_noblock(state_->server, 0) > 0) {
  }
}

int OscServer::port() const {
  return lo_server_get_port(state_->server);
}

std::size_t OscServer::refused() const {
  return state_->refused;
}

}  // namespace idiophone::drivers

// The C functions of idiophone/voices.h.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/voices.h"
#include "stage_checks.hpp"

struct idiophone_map {
  idiophone::engines::SharedMap map;
};
struct idiophone_proxy {
  idiophone::engines::SharedProxy proxy;
};
struct idiophone_stage {
  idiophone::engines::EngineStage stage;
};

namespace idiophone::engines {

namespace {

std::string& last_message() {
  thread_local std::string message;
  return message;
}

void remember(const char* text) noexcept {
  try {
    last_message() = text;
  } catch (...) {
    last_message().clear();  // no memory for the text
  }
}

/// Calls a function that may throw, and says how it went.
/// @param otherwise  what a std::exception means
template <class Function>
idiophone_status answer(idiophone_status otherwise, const Function& function) noexcept {
  try {
    function();
    return IDIOPHONE_OK;
  } catch (const std::bad_alloc&) {
    remember("there is no memory for it");
    return IDIOPHONE_NO_MEMORY;
  } catch (const std::invalid_argument& error) {
    remember(error.what());
    return IDIOPHONE_BAD_ARGUMENT;
  } catch (const std::exception& error) {
    remember(error.what());
    return otherwise;
  }
}

/// @throws std::invalid_argument for a null pointer
void require_given(const void* pointer, const std::string& name) {
  if (pointer == nullptr) {
    throw std::invalid_argument(name + " is null");
  }
}

/// @throws std::invalid_argument for a number below 0
std::size_t count_of(int32_t count, const char* name) {
  if (count < 0) {
    throw std::invalid_argument(fmt::format("{} is {}, below 0", name, count));
  }
  return static_cast<std::size_t>(count);
}

Triple triple_at(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// Their number is checked before they are read: a wrong one leads beyond the end of the list.
/// @throws std::invalid_argument for a number that is not from `least` to `most`
std::vector<Triple> ears_at(const double* numbers, int32_t count, std::size_t least, std::size_t most) {
  if (count < static_cast<std::int64_t>(least) || count > static_cast<std::int64_t>(most)) {
    throw std::invalid_argument(least == most ? fmt::format("the stage has {} ears, not {}", most, count)
                                              : fmt::format("`ear_count` is {}, not {} to {}", count, least, most));
  }
  std::vector<Triple> ears;
  for (std::int32_t i = 0; i < count; ++i) {
    ears.push_back(triple_at(numbers + 3 * static_cast<std::ptrdiff_t>(i)));
  }
  return ears;
}

Surface surface_of(const idiophone_surface& surface) {
  return {.young = surface.young,
          .poisson = surface.poisson,
          .radius = surface.radius,
          .height = surface.height,
          .exponent = surface.exponent,
          .longest = surface.longest,
          .shortest = surface.shortest,
          .friction = surface.friction};
}

StageOptions options_of(const idiophone_options& options) {
  require_given(options.ears, "`ears` of the options");
  StageOptions found{.rate = options.rate,
                     .ears = ears_at(options.ears, options.ear_count, 1, most_channels),
                     .latency = options.latency,
                     .most_strokes = count_of(options.most_strokes, "`most_strokes`"),
                     .seed = options.seed};
  const auto set = [](auto& number, auto wanted) { number = wanted == 0 ? number : wanted; };
  set(found.budget, options.budget);
  set(found.speed, options.speed);
  set(found.most_proxies, count_of(options.most_proxies, "`most_proxies`"));
  set(found.air_density, options.air_density);
  set(found.air_speed, options.air_speed);
  return found;
}

ContactEvent event_of(const idiophone_contact& contact) {
  if (contact.phase < IDIOPHONE_BEGIN || contact.phase > IDIOPHONE_END) {
    throw std::invalid_argument(fmt::format("a contact has the phase {}; there are 0, 1 and 2", contact.phase));
  }
  if (contact.reserved != 0) {
    throw std::invalid_argument(fmt::format("`reserved` is {}; it has to be 0", contact.reserved));
  }
  return {.contact = contact.contact,
          .phase = static_cast<ContactEvent::Phase>(contact.phase),
          .bodies = {contact.bodies[0], contact.bodies[1]},
          .surfaces = {contact.surfaces[0], contact.surfaces[1]},
          .point = triple_at(contact.point),
          .normal = triple_at(contact.normal),
          .impulse = contact.impulse,
          .slip = triple_at(contact.slip),
          .roll = contact.roll,
          .mass = contact.mass,
          .moment = contact.moment};
}

}  // namespace

extern "C" {
#pragma GCC visibility push(default)  // the header declares them outside this namespace, so its attributes don't count

const char* idiophone_message() {
  return last_message().c_str();
}

idiophone_status idiophone_measured_speed(double* speed) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(speed, "the speed");
    *speed = measured_speed();
  });
}

idiophone_status idiophone_map_read(const char* file, idiophone_map** map) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_given(file, "the file's name");
    require_given(map, "the map");
    *map = nullptr;
    *map = new idiophone_map{read_map(std::filesystem::path(file))};
  });
}

idiophone_status idiophone_map_from_bytes(const void* bytes, uint64_t size, idiophone_map** map) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_given(bytes, "the bytes");
    require_given(map, "the map");
    *map = nullptr;
    *map = new idiophone_map{read_map({static_cast<const char*>(bytes), size}, "a voice in memory")};
  });
}

void idiophone_map_free(idiophone_map* map) {
  delete map;
}

idiophone_status idiophone_proxy_read(const char* file, idiophone_proxy** proxy) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_given(file, "the file's name");
    require_given(proxy, "the proxy");
    *proxy = nullptr;
    *proxy = new idiophone_proxy{read_proxy(std::filesystem::path(file))};
  });
}

idiophone_status idiophone_proxy_from_bytes(const void* bytes, uint64_t size, idiophone_proxy** proxy) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_given(bytes, "the bytes");
    require_given(proxy, "the proxy");
    *proxy = nullptr;
    *proxy = new idiophone_proxy{read_proxy({static_cast<const char*>(bytes), size}, "a proxy in memory")};
  });
}

void idiophone_proxy_free(idiophone_proxy* proxy) {
  delete proxy;
}

idiophone_status idiophone_stage_create(const idiophone_options* options, const idiophone_map* const* bodies,
                                        int32_t body_count, const idiophone_surface* surfaces, int32_t surface_count,
                                        idiophone_stage** stage) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    *stage = nullptr;
    require_given(options, "the options");
    if (body_count != 0) {
      require_given(bodies, "the list of bodies");
    }
    require_given(surfaces, "the list of surfaces");
    std::vector<SharedMap> maps;
    for (std::size_t i = 0; i < count_of(body_count, "the number of bodies"); ++i) {
      require_given(bodies[i], fmt::format("the map of body {}", i));
      maps.push_back(bodies[i]->map);
    }
    std::vector<Surface> sides(count_of(surface_count, "the number of surfaces"));
    std::transform(surfaces, surfaces + sides.size(), sides.begin(), surface_of);
    *stage = new idiophone_stage{{options_of(*options), maps, std::move(sides)}};
  });
}

void idiophone_stage_free(idiophone_stage* stage) {
  delete stage;
}

idiophone_status idiophone_stage_add(idiophone_stage* stage, const idiophone_map* map, int32_t* body) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(map, "the map");
    require_given(body, "the number of the body");
    *body = static_cast<int32_t>(stage->stage.add(map->map));
  });
}

idiophone_status idiophone_stage_add_proxy(idiophone_stage* stage, const idiophone_proxy* proxy, int32_t* body) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(proxy, "the proxy");
    require_given(body, "the number of the body");
    *body = static_cast<int32_t>(stage->stage.add(proxy->proxy));
  });
}

idiophone_status idiophone_stage_remove(idiophone_stage* stage, int32_t body) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    stage->stage.remove(count_of(body, "the number of the body"));
  });
}

idiophone_status idiophone_stage_place(idiophone_stage* stage, int32_t body, const double* position,
                                       const double* turn) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(position, "the position");
    require_given(turn, "the turn");
    stage->stage.place(count_of(body, "the number of the body"),
                       {triple_at(position), {turn[0], turn[1], turn[2], turn[3]}});
  });
}

idiophone_status idiophone_stage_tune(idiophone_stage* stage, int32_t body, double tension, double friction,
                                      double size) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    stage->stage.tune(count_of(body, "the number of the body"),
                      {.tension = tension, .friction = friction, .size = size});
  });
}

idiophone_status idiophone_stage_listen(idiophone_stage* stage, const double* ears, int32_t ear_count) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(ears, "the list of ears");
    stage->stage.listen(ears_at(ears, ear_count, stage->stage.channels(), stage->stage.channels()));
  });
}

idiophone_status idiophone_stage_contact(idiophone_stage* stage, const idiophone_contact* contact) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(contact, "the contact");
    stage->stage.contact(event_of(*contact));
  });
}

idiophone_status idiophone_stage_step(idiophone_stage* stage, double duration) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    stage->stage.step(duration);
  });
}

idiophone_status idiophone_stage_report(idiophone_stage* stage, idiophone_report* report) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_given(stage, "the stage");
    require_given(report, "the report");
    const StageReport found = stage->stage.report();
    *report = {.sounding = found.sounding,
               .modes = found.modes,
               .heard = found.heard,
               .strokes = found.strokes,
               .impacts = found.impacts,
               .left_out = found.left_out,
               .cost = found.cost,
               .loss = found.loss,
               .proxies = found.proxies,
               .proxy_cost = found.proxy_cost,
               .gaps = found.gaps};
  });
}

idiophone_status idiophone_stage_render(idiophone_stage* stage, float* sound, uint64_t frames, double full_scale) {
  if (stage == nullptr || sound == nullptr || !(full_scale > 0.0)) {
    return IDIOPHONE_BAD_ARGUMENT;  // a message would take memory
  }
  stage->stage.render(std::span(sound, frames * stage->stage.channels()), full_scale);
  return IDIOPHONE_OK;
}

#pragma GCC visibility pop
}  // extern "C"

}  // namespace idiophone::engines

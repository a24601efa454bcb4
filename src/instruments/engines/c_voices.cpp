// The C functions of idiophone/voices.h.

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/voices.h"

struct idiophone_map {
  idiophone::engines::SharedMap map;
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

/// Calls a function that may throw, and says how it went.
/// @param otherwise  what a std::exception means
template <class Function>
idiophone_status answer(idiophone_status otherwise, const Function& function) noexcept {
  try {
    function();
    return IDIOPHONE_OK;
  } catch (const std::bad_alloc&) {
    last_message().clear();  // no memory for a text
    return IDIOPHONE_NO_MEMORY;
  } catch (const std::invalid_argument& error) {
    last_message() = error.what();
    return IDIOPHONE_BAD_ARGUMENT;
  } catch (const std::exception& error) {
    last_message() = error.what();
    return otherwise;
  }
}

/// @throws std::invalid_argument for a null pointer
template <class... Pointers>
void require_pointers(const Pointers*... pointers) {
  if (!((pointers != nullptr) && ...)) {
    throw std::invalid_argument("a pointer is null");
  }
}

std::size_t count_of(int32_t count) {
  if (count < 0) {
    throw std::invalid_argument("a number of things is below 0");
  }
  return static_cast<std::size_t>(count);
}

Triple triple_at(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<Triple> triples_at(const double* numbers, std::size_t count) {
  std::vector<Triple> triples;
  for (std::size_t i = 0; i < count; ++i) {
    triples.push_back(triple_at(numbers + 3 * i));
  }
  return triples;
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
  require_pointers(options.ears);
  StageOptions found{.rate = options.rate,
                     .ears = triples_at(options.ears, count_of(options.ear_count)),
                     .latency = options.latency,
                     .most_strokes = count_of(options.most_strokes),
                     .seed = options.seed};
  if (options.budget != 0.0) {
    found.budget = options.budget;
  }
  return found;
}

ContactEvent event_of(const idiophone_contact& contact) {
  if (contact.phase < IDIOPHONE_BEGIN || contact.phase > IDIOPHONE_END) {
    throw std::invalid_argument("a contact has no such phase");
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

const char* idiophone_message() {
  return last_message().c_str();
}

idiophone_status idiophone_map_read(const char* file, idiophone_map** map) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_pointers(file, map);
    *map = new idiophone_map{read_map(std::filesystem::path(file))};
  });
}

idiophone_status idiophone_map_from_bytes(const void* bytes, uint64_t size, idiophone_map** map) {
  return answer(IDIOPHONE_BAD_FILE, [&] {
    require_pointers(bytes, map);
    *map = new idiophone_map{read_map({static_cast<const char*>(bytes), size}, "a voice in memory")};
  });
}

void idiophone_map_free(idiophone_map* map) {
  delete map;
}

idiophone_status idiophone_stage_create(const idiophone_options* options, const idiophone_map* const* bodies,
                                        int32_t body_count, const idiophone_surface* surfaces, int32_t surface_count,
                                        idiophone_stage** stage) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(options, bodies, surfaces, stage);
    std::vector<SharedMap> maps;
    for (std::size_t i = 0; i < count_of(body_count); ++i) {
      require_pointers(bodies[i]);
      maps.push_back(bodies[i]->map);
    }
    std::vector<Surface> sides(count_of(surface_count));
    std::transform(surfaces, surfaces + sides.size(), sides.begin(), surface_of);
    *stage = new idiophone_stage{{options_of(*options), maps, std::move(sides)}};
  });
}

void idiophone_stage_free(idiophone_stage* stage) {
  delete stage;
}

idiophone_status idiophone_stage_place(idiophone_stage* stage, int32_t body, const double* position,
                                       const double* turn) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage, position, turn);
    stage->stage.place(count_of(body), {triple_at(position), {turn[0], turn[1], turn[2], turn[3]}});
  });
}

idiophone_status idiophone_stage_listen(idiophone_stage* stage, const double* ears, int32_t ear_count) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage, ears);
    stage->stage.listen(triples_at(ears, count_of(ear_count)));
  });
}

idiophone_status idiophone_stage_contact(idiophone_stage* stage, const idiophone_contact* contact) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage, contact);
    stage->stage.contact(event_of(*contact));
  });
}

idiophone_status idiophone_stage_step(idiophone_stage* stage, double duration) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage);
    stage->stage.step(duration);
  });
}

idiophone_status idiophone_stage_report(idiophone_stage* stage, idiophone_report* report) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage, report);
    const StageReport found = stage->stage.report();
    *report = {.sounding = found.sounding,
               .modes = found.modes,
               .heard = found.heard,
               .strokes = found.strokes,
               .impacts = found.impacts,
               .left_out = found.left_out,
               .cost = found.cost,
               .loss = found.loss};
  });
}

idiophone_status idiophone_stage_render(idiophone_stage* stage, float* sound, uint64_t frames, double full_scale) {
  return answer(IDIOPHONE_BAD_ARGUMENT, [&] {
    require_pointers(stage, sound);
    if (!(full_scale > 0.0)) {
      throw std::invalid_argument("the full scale has to be above 0 Pa");
    }
    stage->stage.render(std::span(sound, frames * stage->stage.channels()), full_scale);
  });
}

}  // extern "C"

}  // namespace idiophone::engines

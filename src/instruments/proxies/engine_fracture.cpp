// Bodies that break while they sound (O'Morain 2005, section 9.3.1).

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine_state.hpp"

namespace idiophone::proxies {

std::size_t Engine::State::present_body(std::size_t body, const Vector3& point) const {
  while (pieces.contains(body)) {
    body = *std::ranges::min_element(pieces.at(body), {}, [&](std::size_t piece) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector3& node : voices[piece].body().levels.front()->mesh().nodes) {
        nearest = std::min(nearest, (node - point).norm());
      }
      return nearest;
    });
  }
  return body;
}

void Engine::State::break_overloaded() {
  for (std::size_t body = 0, count = voices.size(); body < count; ++body) {
    if (!voices[body].is_breakable()) {
      continue;
    }
    const Fragment whole = voices[body].fragment();
    const std::vector<Overload> overloaded = overloads(whole, voices[body].body().strength);
    if (!overloaded.empty()) {
      std::vector<Fragment> parts = broken(whole, overloaded);
      parts.size() == 1 ? crack(voices[body], parts.front()) : fracture(body, whole, std::move(parts));
    }
  }
}

void Engine::State::crack(Voice& voice, const Fragment& cracked) {
  try {
    voice.go_on_as(cracked);
  } catch (const std::invalid_argument&) {  // its springs are too short
    voice.hold();
  }
}

void Engine::State::fracture(std::size_t body, const Fragment& whole, std::vector<Fragment> parts) {
  const auto energy_of = [](const Fragment& fragment) {
    const FragmentSums sums = sums_of(fragment);
    return sums.kinetic_energy + sums.elastic_energy;
  };
  std::ranges::stable_sort(parts, std::greater(), [](const Fragment& part) { return sums_of(part).mass; });
  Fracture fracture{.sample = now, .body = body, .released = energy_of(whole)};
  const std::vector<Force> forces = voices[body].stop();
  note(voices[body], Choice::Kind::end, now);
  pieces[body] = {};
  for (Fragment& part : parts) {
    fracture.released -= energy_of(part);
    fracture.pieces.push_back(add_piece(body, part));
  }
  if (pieces[body].empty()) {
    pieces.erase(body);
  }
  fractures.push_back(std::move(fracture));
  for (const Force& force : forces) {
    begin(force, now);
  }
}

Piece Engine::State::add_piece(std::size_t body, Fragment& part) {
  Piece piece{.mass = part.lattice->inertia().mass, .centre = part.lattice->inertia().centre};
  piece.motion = take_rigid_motion(part);
  BodyOptions like = voices[body].body();
  like.levels = {part.lattice};
  const Tuning tuning = voices[body].tuning();
  try {
    Voice voice(std::move(like), options, voices.size());
    voice.require_tunable(tuning);
    voice.tune(tuning);
    voices.push_back(std::move(voice));
  } catch (const std::invalid_argument&) {
    return piece;
  }
  piece.body = voices.size() - 1;
  pieces[body].push_back(*piece.body);
  parents[*piece.body] = body;
  Voice& voice = voices.back();
  if (make_room(voice.priority(), voice.smallest_cost(), now)) {
    voice.begin(choose_detail(voice, voice.priority()), now);
    voice.go_on_as(part);
    note(voice, Choice::Kind::begin, now);
  } else {
    note(voice, Choice::Kind::refuse, now);
  }
  return piece;
}

std::size_t Engine::State::ancestor(std::size_t body, std::size_t count) const {
  while (body >= count) {
    body = parents.at(body);
  }
  return body;
}

}  // namespace idiophone::proxies

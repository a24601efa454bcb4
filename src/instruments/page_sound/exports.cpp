// What the page calls (compiled_modes.js). Numbers go both ways through one list in the memory of WebAssembly.

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "page_body.hpp"
#include "page_contacts.hpp"

#ifdef __wasm__
#define IDIOPHONE_EXPORT(name) extern "C" [[clang::export_name(name)]]
#else
#define IDIOPHONE_EXPORT(name) extern "C"  // compiled as well, so that tests and analysers see it
#endif

namespace idiophone::page_sound {

namespace {

std::vector<double>& numbers() {
  static std::vector<double> list;
  return list;
}

/// Numbers of the list, one after the other.
class Reader {
 public:
  std::span<const double> next(std::size_t count) {
    return std::span(numbers()).subspan(std::exchange(at_, at_ + count), count);
  }
  double next() { return next(1).front(); }
  touching::Triple triple() { return {next(), next(), next()}; }
  std::array<std::int32_t, 2> pair() { return {static_cast<std::int32_t>(next()), static_cast<std::int32_t>(next())}; }
  Participation participation(std::size_t modes) {
    const std::span<const double> of_modes = next(modes);
    return {of_modes.begin(), of_modes.end()};
  }

 private:
  std::size_t at_ = 0;
};

/// Numbers: A [terms x modes], T [modes x modes], and of H each pair of modes that is not zero: its places in [terms x
/// modes x modes], [pairs], and its numbers, [pairs].
resonators::StretchedModes next_stretching(Reader& reader, std::size_t modes, std::size_t terms, std::size_t pairs,
                                           int rate) {
  const auto linear = reader.next(terms * modes), rotation = reader.next(modes * modes);
  const auto places = reader.next(pairs), values = reader.next(pairs);
  std::vector<double> quadratic(terms * modes * modes);
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const auto place = static_cast<std::size_t>(places[pair]);
    const std::size_t row = place / modes, first = row % modes, second = place % modes;
    quadratic[place] = quadratic[(row - first + second) * modes + first] = values[pair];
  }
  const std::vector<resonators::ModeGroup> still = resonators::in_groups(std::vector<resonators::Complex>(modes));
  return {resonators::StretchingEnergy(linear, quadratic, modes), rotation, still, rate};
}

touching::ContactEvent next_event(Reader& reader) {
  touching::ContactEvent event;
  event.contact = static_cast<std::uint64_t>(reader.next());
  event.phase = touching::ContactEvent::Phase::persist;
  event.bodies = reader.pair();
  event.surfaces = reader.pair();
  event.point = reader.triple();
  event.normal = reader.triple();
  event.impulse = reader.next();
  event.slip = reader.triple();
  event.roll = reader.next();
  event.mass = reader.next();
  event.moment = reader.next();
  return event;
}

void append(std::vector<double>& list, const touching::ContactForce& force) {
  const auto& [start, at, direction, pieces] = force.force;
  list.insert(list.end(), {static_cast<double>(force.bodies[0]), static_cast<double>(force.bodies[1]),
                           static_cast<double>(start), at.x(), at.y(), at.z(), direction.x(), direction.y(),
                           direction.z(), static_cast<double>(pieces.size())});
  for (const auto part :
       {&resonators::ForcePiece::mean, &resonators::ForcePiece::slope, &resonators::ForcePiece::begin}) {
    std::ranges::transform(pieces, std::back_inserter(list), part);
  }
}

}  // namespace

/// Makes the list that long. @return where it is
IDIOPHONE_EXPORT("exchange")
double* exchange(std::size_t count) {
  numbers().resize(count);
  return numbers().data();
}

IDIOPHONE_EXPORT("make_body")
PageBody* make_body(std::size_t modes, std::size_t channels, int rate) {
  return new PageBody(modes, channels, rate);
}

/// A body whose vibrations may be large (docs/method/large_amplitudes.md). Numbers: A [terms x modes], T [modes x
/// modes], and of each pair of modes that has a number in H: places [pairs], numbers [pairs].
IDIOPHONE_EXPORT("make_stretched_body")
PageBody* make_stretched_body(std::size_t modes, std::size_t channels, int rate, std::size_t terms, std::size_t pairs) {
  Reader reader;
  return new PageBody(modes, channels, rate, next_stretching(reader, modes, terms, pairs, rate));
}

/// Numbers: frequency and decay [modes], pressure [channels x modes x 2].
/// @param size  of the body over that of its map
IDIOPHONE_EXPORT("tune")
void tune(PageBody* body, std::size_t modes, std::size_t channels, double size) {
  Reader reader;
  body->tune({.frequency = reader.next(modes),
              .decay = reader.next(modes),
              .pressure = reader.next(2 * channels * modes),
              .size = size});
}

/// Numbers: participation [modes]; mean, slope and begin of the force [samples].
IDIOPHONE_EXPORT("strike")
void strike(PageBody* body, std::size_t modes, double start, std::size_t samples) {
  Reader reader;
  Participation participation = reader.participation(modes);
  const auto mean = reader.next(samples), slope = reader.next(samples), begin = reader.next(samples);
  resonators::ForceCurve force;
  for (std::size_t i = 0; i < samples; ++i) {
    force.push_back({.mean = mean[i], .slope = slope[i], .begin = begin[i]});
  }
  body->strike(static_cast<std::int64_t>(start), std::move(force), std::move(participation));
}

/// Numbers: participation [modes].
IDIOPHONE_EXPORT("put_bow")
void put_bow(PageBody* body, std::size_t modes, int number) {
  body->put_bow(number, {}, Reader().participation(modes));
}

/// Numbers: participation [modes].
IDIOPHONE_EXPORT("lead_bow")
void lead_bow(PageBody* body, std::size_t modes, int number, double speed, double load) {
  body->lead_bow(number, {.speed = speed, .load = load}, Reader().participation(modes));
}

IDIOPHONE_EXPORT("lift_bow")
void lift_bow(PageBody* body, int number) {
  body->lift_bow(number);
}

/// Numbers afterwards: [samples x channels], if anything sounds.
IDIOPHONE_EXPORT("render")
bool render(PageBody* body, std::size_t channels, double first, std::size_t samples) {
  numbers().resize(samples * channels);
  return body->render(static_cast<std::int64_t>(first), numbers());
}

/// The largest so far, root mean square over the body, rad.
IDIOPHONE_EXPORT("rotation")
double rotation(const PageBody* body) {
  return body->largest_rotation();
}

/// Numbers: Young's modulus, Poisson's ratio, radius, height of the roughness, friction [surfaces x 5].
IDIOPHONE_EXPORT("make_contacts")
PageContacts* make_contacts(std::size_t surfaces, int rate, std::size_t most_strokes, std::size_t most_impacts,
                            double seed) {
  Reader reader;
  std::vector<touching::Surface> made;
  for (std::size_t i = 0; i < surfaces; ++i) {
    touching::Surface& surface = made.emplace_back();
    for (double* part : {&surface.young, &surface.poisson, &surface.radius, &surface.height, &surface.friction}) {
      *part = reader.next();
    }
  }
  return new PageContacts(std::move(made), rate, most_strokes, most_impacts, static_cast<std::uint64_t>(seed));
}

/// Numbers: contact, bodies, surfaces, point, normal, impulse, slip, roll, mass, moment of each event. Afterwards:
/// bodies, audio sample, place, direction, how many samples, and mean, slope and begin [samples] of each force.
/// @return how many numbers there are afterwards
IDIOPHONE_EXPORT("step_contacts")
std::size_t step_contacts(PageContacts* contacts, std::size_t events, double start, double duration) {
  Reader reader;
  std::vector<touching::ContactEvent> happened;
  for (std::size_t i = 0; i < events; ++i) {
    happened.push_back(next_event(reader));
  }
  const auto forces = contacts->step(happened, static_cast<std::int64_t>(start), duration);
  numbers().clear();
  for (const touching::ContactForce& force : forces) {
    append(numbers(), force);
  }
  return numbers().size();
}

IDIOPHONE_EXPORT("end_contacts")
void end_contacts(PageContacts* contacts) {
  delete contacts;
}

}  // namespace idiophone::page_sound

// What the page calls (compiled_modes.js). Numbers go both ways through one list in the memory of WebAssembly.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "page_body.hpp"

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
  Participation participation(std::size_t modes) {
    const std::span<const double> of_modes = next(modes);
    return {of_modes.begin(), of_modes.end()};
  }

 private:
  std::size_t at_ = 0;
};

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

/// Numbers: frequency and decay [modes], pressure [channels x modes x 2].
IDIOPHONE_EXPORT("tune")
void tune(PageBody* body, std::size_t modes, std::size_t channels) {
  Reader reader;
  body->tune(
      {.frequency = reader.next(modes), .decay = reader.next(modes), .pressure = reader.next(2 * channels * modes)});
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

}  // namespace idiophone::page_sound

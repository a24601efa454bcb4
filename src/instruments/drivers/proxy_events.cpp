#include "idiophone/instruments/drivers/proxy_events.hpp"

#include "idiophone/instruments/resonators/point_forces.hpp"

namespace idiophone::drivers {

std::vector<proxies::Force> event_forces(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed,
                                         int rate) {
  std::vector<proxies::Force> forces;
  for (const resonators::PointForce& point : resonators::point_forces(event, start, seed, rate)) {
    proxies::Force& force = forces.emplace_back(proxies::Force{
        .body = event.body, .start = point.start, .at = point.at, .direction = point.direction, .curve = {}});
    for (const resonators::ForcePiece& piece : point.force) {
      force.curve.push_back(piece.mean);
    }
  }
  return forces;
}

std::optional<proxies::Tuning> tuning_of(const score::ScoreEvent& event, std::int64_t start) {
  const auto* tuning = std::get_if<score::Tuning>(&event.action);
  if (tuning == nullptr) {
    return std::nullopt;
  }
  return proxies::Tuning{.body = event.body,
                         .start = start,
                         .tension = tuning->tension,
                         .friction = tuning->friction,
                         .size = tuning->size};
}

void add_event(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed, int rate,
               proxies::Engine& engine) {
  if (const auto tuning = tuning_of(event, start)) {
    engine.add(*tuning);
  }
  for (proxies::Force& force : event_forces(event, start, seed, rate)) {
    engine.add(std::move(force));
  }
}

}  // namespace idiophone::drivers

#include "events.hpp"

#include "idiophone/instruments/resonators/point_forces.hpp"

namespace idiophone::voices {

std::vector<Command> commands_of(const score::ScoreEvent& event, const Instrument& instrument, std::int64_t start,
                                 std::uint64_t seed) {
  std::vector<Command> commands;
  for (resonators::PointForce& force : resonators::point_forces(event, start, seed, instrument.rate())) {
    auto excitation = instrument.excite(force.at, force.direction, std::move(force.force));
    excitation->body = event.body;
    excitation->start = force.start;
    commands.emplace_back(std::move(excitation));
  }
  return commands;
}

}  // namespace idiophone::voices

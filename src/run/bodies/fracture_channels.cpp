#include "idiophone/run/bodies/fracture_channels.hpp"

#include <string>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::bodies {

namespace {

/// Names of the columns for the pieces of a body: 1, 2, ...
std::vector<std::string> numbers_up_to(Index count) {
  std::vector<std::string> numbers;
  for (Index number = 1; number <= count; ++number) {
    numbers.push_back(std::to_string(number));
  }
  return numbers;
}

std::vector<spectra::Series> fracture_series(const Preparation& ready) {
  std::vector<spectra::Series> all;
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const scene::Body& body = ready.scene.bodies[b];
    if (body.fracture.empty()) {
      continue;
    }
    const std::string path = "/motion/" + body.name;
    all.push_back({path + "/broken_area",
                   "m2",
                   0.0,
                   {"area"},
                   "undeformed area of the broken faces of the fracture surfaces, one side of each",
                   {}});
    all.push_back({path + "/fracture_energy",
                   "J",
                   0.0,
                   {"energy"},
                   "energy that breaking has taken, with what cohesion still stores",
                   {}});
    if (const Index pieces = ready.part.piece_count(b); pieces > 0) {
      all.push_back({path + "/joined_pieces",
                     "1",
                     0.0,
                     numbers_up_to(pieces),
                     "of each piece, the number of the first one that it still hangs together with",
                     {}});
    }
  }
  return all;
}

}  // namespace

FractureChannels::FractureChannels(const Preparation& ready, const motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(ready.scene, fracture_series(ready)), motion_(motion), communicator_(communicator) {}

void FractureChannels::note_row() {
  for (const motion::BodyFracture& fracture : motion_.dynamics().fractures()) {
    values_.push_back(fracture.broken_area());
    values_.push_back(fracture.taken_energy());
    for (const Index piece : fracture.joined_pieces()) {
      values_.push_back(static_cast<double>(piece));
    }
  }
}

std::vector<std::vector<double>> FractureChannels::collect() {
  std::vector<std::vector<double>> rows(channels().size());
  parallel::sum_on_root(std::span(values_), communicator_);
  for (auto next = values_.begin(); parallel::is_root(communicator_) && next != values_.end();) {
    for (std::size_t channel = 0; channel < rows.size(); ++channel) {
      const auto end = next + static_cast<std::ptrdiff_t>(channels()[channel].columns.size());
      rows[channel].insert(rows[channel].end(), next, end);
      next = end;
    }
  }
  values_.clear();
  return rows;
}

}  // namespace idiophone::bodies

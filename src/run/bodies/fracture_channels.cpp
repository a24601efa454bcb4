#include "idiophone/run/bodies/fracture_channels.hpp"

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::bodies {

namespace {

std::vector<spectra::Series> fracture_series(const scene::Scene& scene) {
  std::vector<spectra::Series> all;
  for (const scene::Body& body : scene.bodies) {
    if (!body.fracture.empty()) {
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
    }
  }
  return all;
}

}  // namespace

FractureChannels::FractureChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(scene, fracture_series(scene)), motion_(motion), communicator_(communicator) {}

void FractureChannels::note_row() {
  for (const motion::BodyFracture& fracture : motion_.dynamics().fractures()) {
    rows_.push_back(fracture.broken_area());
    rows_.push_back(fracture.taken_energy());
  }
}

std::vector<std::vector<double>> FractureChannels::collect() {
  std::vector<std::vector<double>> series(channels().size());
  parallel::sum_on_root(std::span(rows_), communicator_);  // zero on all ranks but one
  for (std::size_t i = 0; parallel::is_root(communicator_) && i < rows_.size(); ++i) {
    series[i % series.size()].push_back(rows_[i]);
  }
  rows_.clear();
  return series;
}

}  // namespace idiophone::bodies

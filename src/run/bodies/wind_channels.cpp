#include "idiophone/run/bodies/wind_channels.hpp"

#include <span>

#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

namespace {

std::vector<spectra::Series> wind_series(const scene::Scene& scene) {
  std::vector<spectra::Series> all;
  for (const scene::Wind& wind : scene.winds) {
    all.push_back(
        {"/loads/" + wind.name + "/force", "N", 0.0, {"x", "y", "z"}, "total force of the wind on the bodies", {}});
  }
  return all;
}

}  // namespace

WindChannels::WindChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(scene, wind_series(scene)), motion_(motion), communicator_(communicator) {}

void WindChannels::note_row() {
  for (const motion::Wind& wind : motion_.dynamics().loads().winds()) {
    for (const ReproducibleSum& sum : wind.total(motion_.time(), motion_.state())) {
      append(words_, sum);
    }
  }
}

std::vector<std::vector<double>> WindChannels::collect() {
  std::vector<std::vector<double>> series(channels().size());
  if (words_.empty()) {
    return series;
  }
  const std::vector<std::int64_t> sums = sum_over_ranks(words_, communicator_);
  words_.clear();
  constexpr std::size_t components = 3;
  std::span<const std::int64_t> words = sums;
  for (std::size_t i = 0; !words.empty(); ++i) {
    series[i / components % series.size()].push_back(take_sum(words).value());
  }
  return series;
}

}  // namespace idiophone::bodies

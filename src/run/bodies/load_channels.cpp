#include "idiophone/run/bodies/load_channels.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

namespace {

std::vector<spectra::Series> load_series(const scene::Scene& scene) {
  std::vector<spectra::Series> all;
  const auto add = [&](const std::string& load, const std::string& description) {
    all.push_back({"/loads/" + load + "/force", "N", 0.0, {"x", "y", "z"}, description, {}});
  };
  for (const scene::Wind& wind : scene.winds) {
    add(wind.name, "total force of the wind on the bodies");
  }
  for (const scene::Bow& bow : scene.bows) {
    add(bow.name, "friction of the bow on its body");
  }
  return all;
}

}  // namespace

LoadChannels::LoadChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(scene, load_series(scene)), motion_(motion), communicator_(communicator) {}

void LoadChannels::note_row() {
  const auto note = [this](const auto& load) {
    for (const ReproducibleSum& sum : load.total(motion_.time(), motion_.state())) {
      append(words_, sum);
    }
  };
  std::ranges::for_each(motion_.dynamics().loads().winds(), note);
  std::ranges::for_each(motion_.dynamics().loads().bows(), note);
}

std::vector<std::vector<double>> LoadChannels::collect() {
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

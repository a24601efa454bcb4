#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

double modelled_depth(const Cut& cut) {
  return cut.tool.profile == Profile::groove ? cut.depth * (1 + cut.depth / cut.tool.radius) : cut.depth;
}

double modelled_depth_slope(const Cut& cut) {
  return cut.tool.profile == Profile::groove ? 1 + 2 * cut.depth / cut.tool.radius : 1.0;
}

double depth_of(const std::vector<Cut>& cuts, double along) {
  double depth = 0.0;
  for (const Cut& cut : cuts) {
    depth += cut.depth * depth_share(cut.tool, along - cut.place);
  }
  return depth;
}

double mean_depth_of(const std::vector<Cut>& cuts, const std::array<double, 2>& ends) {
  double depth = 0.0;
  for (const Cut& cut : cuts) {
    depth += cut.depth * mean_depth_share(cut.tool, ends[0] - cut.place, ends[1] - cut.place);
  }
  return depth;
}

}  // namespace idiophone::bench

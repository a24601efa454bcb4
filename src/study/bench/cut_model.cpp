#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

double depth_of(const std::vector<Cut>& cuts, double along) {
  double depth = 0.0;
  for (const Cut& cut : cuts) {
    depth += cut.depth * depth_share(cut.tool, along - cut.place);
  }
  return depth;
}

}  // namespace idiophone::bench

#include "idiophone/solids/motion/measure.hpp"

namespace idiophone::motion {

std::vector<BodySums> measure(Motion& motion, const InitialState& initial_state) {
  std::vector<BodySums> bodies(initial_state.masses.size());
  motion.add_sums(initial_state, bodies);
  return bodies;
}

}  // namespace idiophone::motion

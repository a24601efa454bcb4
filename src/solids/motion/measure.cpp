#include "idiophone/solids/motion/measure.hpp"

namespace idiophone::motion {

std::vector<BodySums> measure(Motion& motion, const InitialState& initial_state) {
  std::vector<BodySums> sums(initial_state.masses.size() + initial_state.pieces.size());
  motion.add_sums(initial_state, sums);
  return sums;
}

}  // namespace idiophone::motion

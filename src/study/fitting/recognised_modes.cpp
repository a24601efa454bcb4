#include "idiophone/study/fitting/recognised_modes.hpp"

namespace idiophone::fitting {

RecognisedModes recognise(Eigen::MatrixXd likeness) {
  constexpr double least = 0.5;
  constexpr double used = -1.0;
  const auto known = static_cast<std::size_t>(likeness.rows());
  RecognisedModes found{std::vector<std::optional<std::size_t>>(known), std::vector<double>(known, 0.0)};
  for (std::size_t round = 0; round < known && likeness.cols() > 0; ++round) {
    Eigen::Index which = 0;
    Eigen::Index mode = 0;
    const double best = likeness.maxCoeff(&which, &mode);
    if (best == used) {
      break;
    }
    const auto place = static_cast<std::size_t>(which);
    found.likeness[place] = best;
    likeness.row(which).setConstant(used);
    if (best >= least) {
      found.modes[place] = static_cast<std::size_t>(mode);
      likeness.col(mode).setConstant(used);
    }
  }
  return found;
}

}  // namespace idiophone::fitting

#include "idiophone/solids/motion/body_sums.hpp"

#include <cmath>
#include <vector>

#include "idiophone/solids/motion/initial_state.hpp"

namespace idiophone::motion {

namespace {

constexpr int travel_exponent = 10;  // of two: the length unit in sizes of the body

double power_of_two_below(double value) {
  return std::scalbn(1.0, std::ilogb(value));
}

}  // namespace

BodyUnits::BodyUnits(const InitialState& initial_state, std::size_t body)
    : mass(power_of_two_below(initial_state.masses[body])),
      length(
          std::scalbn(power_of_two_below(std::sqrt(initial_state.moments[body].trace() / initial_state.masses[body])),
                      travel_exponent)) {}

void BodySums::merge(const BodySums& other) {
  std::vector<const ReproducibleSum*> terms;
  for_each(other, [&](const ReproducibleSum& sum) { terms.push_back(&sum); });
  auto next = terms.begin();
  for_each(*this, [&next](ReproducibleSum& sum) { sum.merge(**next++); });
}

void add(std::array<ReproducibleSum, 3>& sums, const Vector3& terms) {
  for (std::size_t i = 0; i < 3; ++i) {
    sums[i].add(terms[i]);
  }
}

void add(std::array<ReproducibleSum, 9>& sums, const Eigen::Matrix3d& terms) {
  for (std::size_t i = 0; i < 9; ++i) {
    sums[i].add(terms.data()[i]);
  }
}

void add(std::array<ReproducibleSum, 6>& sums, const Eigen::Matrix3d& terms) {
  for (std::size_t entry = 0, column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row <= column; ++row) {
      sums[entry++].add(terms(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
    }
  }
}

}  // namespace idiophone::motion

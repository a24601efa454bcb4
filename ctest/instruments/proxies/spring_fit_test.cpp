#include "idiophone/instruments/proxies/spring_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "bodies.hpp"
#include "frequency_bound.hpp"

namespace idiophone::proxies {
namespace {

constexpr std::size_t fitted_modes = 10;

TetrahedralMesh short_bar() {
  return box({0.2, 0.05, 0.03}, {6, 3, 2}, 0.2);
}

/// The bar from other material: each tetrahedron is softer by a factor of its own.
Lattice softer_bar() {
  OwnValues own;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> factor(0.3, 0.9);
  std::ranges::generate_n(std::back_inserter(own.stiffness), std::ssize(short_bar().tetrahedra),
                          [&] { return factor(random); });
  return {short_bar(), rubber, {}, own};
}

std::vector<KnownMode> elastic_modes(const Lattice& lattice) {
  constexpr Index rigid = 6;
  const Eigensystem all = modes_of(lattice);
  std::vector<KnownMode> modes(fitted_modes);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto column = rigid + static_cast<Eigen::Index>(m);
    modes[m].angular_frequency = std::sqrt(all.eigenvalues()[column]);
    for (Eigen::Index i = 0; i < std::ssize(lattice.masses()); ++i) {
      modes[m].shape.emplace_back(all.eigenvectors().col(column).segment<3>(3 * i));
    }
  }
  return modes;
}

std::vector<double> cents_between(const std::vector<KnownMode>& modes, const std::vector<KnownMode>& references) {
  std::vector<double> cents;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    cents.push_back(1200.0 * std::log2(modes[m].angular_frequency / references[m].angular_frequency));
  }
  return cents;
}

double largest_of(const std::vector<double>& values) {
  return std::abs(std::ranges::max(values, {}, [](double value) { return std::abs(value); }));
}

Lattice with_springs(const Lattice& plain, const SpringFit& fit) {
  OwnValues own;
  own.edges = fit.edges;
  return {plain.mesh(), plain.material(), {}, own};
}

/// sqrt(2 lambda/m) of the mass that its springs hold most stiffly, rad/s
double bound_of_stiffest_mass(const Lattice& lattice) {
  return std::sqrt(std::ranges::max(
      frequency_bounds(lattice.mesh().nodes, lattice.springs(), lattice.masses(), lattice.pinned(), 0).squares));
}

TEST(SpringFit, GivesALatticeTheModesOfAnotherBody) {
  const Lattice plain(short_bar(), rubber);
  const std::vector<KnownMode> known = elastic_modes(softer_bar());
  const SpringFit fit = fit_springs(plain, known);
  const Lattice fitted = with_springs(plain, fit);
  const std::vector<KnownMode> before = elastic_modes(plain), after = elastic_modes(fitted);
  EXPECT_GT(largest_of(cents_between(before, known)), 200.0);
  EXPECT_LT(largest_of(cents_between(after, known)), 2.0);
  for (std::size_t m = 0; m < fitted_modes; ++m) {  // it tells what it reached
    EXPECT_NEAR(fit.before[m], cents_between(before, known)[m], 0.01);
    EXPECT_NEAR(fit.after[m], cents_between(after, known)[m], 0.01);
  }
  for (std::size_t m = 0; m < fitted_modes; ++m) {  // shapes have unit modal mass
    double product = 0.0;
    for (std::size_t i = 0; i < plain.masses().size(); ++i) {
      product += plain.masses()[i] * after[m].shape[i].dot(known[m].shape[i]);
    }
    EXPECT_GT(std::abs(product), 0.99) << m;
  }
}

TEST(SpringFit, KeepsMassesRigidMotionsAndSteps) {
  const Lattice plain(short_bar(), rubber);
  const SpringFit fit = fit_springs(plain, elastic_modes(softer_bar()));
  for (const EdgeFactors& factors : fit.edges) {
    EXPECT_GE(std::ranges::min(factors), 0.02 - 1e-12);
    EXPECT_LE(std::ranges::max(factors), 10.0 + 1e-12);
  }
  const Lattice fitted = with_springs(plain, fit);
  EXPECT_EQ(fitted.masses(), plain.masses());
  EXPECT_LE(fitted.largest_angular_frequency(), (1.0 + 1e-12) * bound_of_stiffest_mass(plain));
  const Eigen::VectorXd squares = modes_of(fitted).eigenvalues();
  EXPECT_LT(squares.head<6>().cwiseAbs().maxCoeff(), 1e-9 * squares.maxCoeff());
  EXPECT_GT(squares[6], 1e-6 * squares.maxCoeff());
}

TEST(SpringFit, NeedsNoMoreStepsThanTheStiffestMassAllows) {
  const Lattice plain(short_bar(), rubber);
  std::vector<KnownMode> known = elastic_modes(plain);
  for (KnownMode& mode : known) {
    mode.angular_frequency *= 2.0;  // more than the limit allows
  }
  const SpringFit fit = fit_springs(plain, known);
  const double largest = with_springs(plain, fit).largest_angular_frequency();
  EXPECT_LE(largest, (1.0 + 1e-12) * bound_of_stiffest_mass(plain));
  EXPECT_GT(largest, plain.largest_angular_frequency());  // it uses what the limit leaves
  EXPECT_LT(std::ranges::min(fit.after), -50.0);
  EXPECT_GT(fit.after[0], fit.before[0] + 50.0);
}

TEST(SpringFit, HoldsPinnedMasses) {
  std::vector<Index> pinned;
  KnownMode bending{.angular_frequency = 1.0, .shape = {}};
  for (const Vector3& node : short_bar().nodes) {
    if (node.x() < 1e-9) {
      pinned.push_back(static_cast<Index>(bending.shape.size()));
    }
    bending.shape.emplace_back(0.0, 0.0, node.x() * node.x());
  }
  const Lattice plain(short_bar(), rubber, pinned);
  const double sharp = fit_springs(plain, std::vector{bending}).before[0];
  bending.angular_frequency = std::exp2((sharp - 300.0) / 1200.0);
  const SpringFit fit = fit_springs(plain, std::vector{bending});
  EXPECT_NEAR(fit.before[0], 300.0, 1e-3);
  EXPECT_NEAR(fit.after[0], 0.0, 5.0);  // the shape is not quite one of its modes
}

TEST(SpringFit, HasFewerModesForCoarserLattices) {
  EXPECT_EQ(modes_to_fit(Lattice(regular_tetrahedron(), rubber)), 2);
  EXPECT_EQ(modes_to_fit(Lattice(short_bar(), rubber)), 19);
  EXPECT_EQ(modes_to_fit(*rubber_cube(8)), 24);
}

TEST(SpringFit, RefusesWhatCannotBeFitted) {
  const Lattice plain(short_bar(), rubber);
  const std::vector<KnownMode> known = elastic_modes(plain);
  const auto refuses = [&](const Lattice& lattice, std::vector<KnownMode> modes) {
    EXPECT_THROW((void)fit_springs(lattice, modes), std::invalid_argument);
  };
  refuses(plain, {});
  refuses(plain, {known[1], known[0]});
  refuses(plain, {known[0], {.angular_frequency = known[1].angular_frequency, .shape = known[0].shape}});
  refuses(*rubber_cube(2), known);
  refuses(plain, {{.angular_frequency = 0.0, .shape = known[0].shape}});
  refuses(plain, {{.angular_frequency = 1.0, .shape = std::vector<Vector3>(plain.masses().size(), Vector3::UnitX())}});
  OwnValues own;
  own.length.assign(plain.mesh().tetrahedra.size(), 0.999);
  refuses(Lattice(short_bar(), rubber, {}, own), known);
}

}  // namespace
}  // namespace idiophone::proxies

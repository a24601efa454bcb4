#include "stretching_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "long_verification.hpp"
#include "modal_coordinates.hpp"
#include "runge_kutta.hpp"

namespace idiophone::modal_bodies {
namespace {

/// Three modes that stretch a body by two strains, of second order as of first: softening and hardening.
ModalBasis curved_body() {
  ModalBasis basis;
  basis.frequencies = {1000, 1700, 4000};
  basis.decay_rates = {0, 0, 0};
  basis.stretching.linear = {500, -300, 100, 0, 800, 2000};
  basis.stretching.quadratic = {900, 200, -100, 200, 500, 50, -100, 50, 1500, -300, 400, 0, 400, 700, 300, 0, 300, 100};
  basis.stretching.rotation.assign(9, 0.0);
  return basis;
}

/// One mode of a flat body: q'' + w^2 q + 2 c^2 q^3 = 0.
ModalBasis flat_body(double frequency, double c) {
  ModalBasis basis;
  basis.frequencies = {frequency};
  basis.decay_rates = {0};
  basis.stretching = {.linear = {0}, .quadratic = {c}, .rotation = {0}};
  return basis;
}

/// Coordinates and how they were moved before.
struct Vibration {
  Vibration(const ModalBasis& of, double dt, const Eigen::ArrayXd& places)
      : basis(of), coordinates(of), length(dt), before(places) {
    coordinates.start(places, Eigen::ArrayXd::Zero(places.size()));
  }

  void advance() {
    before = coordinates.places();
    coordinates.advance(Step(number++, length), Eigen::ArrayXd::Zero(before.size()));
  }

  /// That the recurrence conserves without damping, J.
  [[nodiscard]] double discrete_energy() const {
    const Eigen::VectorXd now = coordinates.places();
    const Eigen::VectorXd last = before;
    double energy = 0.0;
    for (Eigen::Index k = 0; k < now.size(); ++k) {
      const double w = basis.frequencies[static_cast<std::size_t>(k)];
      const double mass = std::pow(w * length / 2 / std::sin(w * length / 2), 2);
      const double rate = (now[k] - last[k]) / length;
      energy += mass * rate * rate / 2 + w * w * now[k] * last[k] / 2;
    }
    return energy + coordinates.stored_energy();
  }

  ModalBasis basis;
  ModalCoordinates coordinates;
  double length;
  Eigen::ArrayXd before;
  std::int64_t number = 0;
};

/// Largest change of the energy in some steps, relative to it.
double drift(const ModalBasis& basis, double length, int steps) {
  Vibration body(basis, length, Eigen::Array3d(1.0, -0.7, 0.4));
  body.advance();
  const double start = body.discrete_energy();
  double worst = 0.0;
  for (int n = 1; n < steps; ++n) {
    body.advance();
    worst = std::max(worst, std::abs(body.discrete_energy() / start - 1));
  }
  return worst;
}

/// The mean time between passages through zero, s.
double period(Vibration& body, int passages) {
  double first = 0.0;
  double last = 0.0;
  for (int found = 0; found <= passages;) {
    body.advance();
    const double now = body.coordinates.places()[0];
    if (body.before[0] * now < 0) {
      last = (static_cast<double>(body.number) - now / (now - body.before[0])) * body.length;
      first = found == 0 ? last : first;
      ++found;
    }
  }
  return 2 * (last - first) / passages;
}

TEST(StretchingForce, ConservesTheEnergyForAnyStep) {
  for (const double length : {1e-6, 2e-5, 3e-4, 6e-4}) {  // the last ones turn the highest mode by 1.2 and 2.4
    EXPECT_LT(drift(curved_body(), length, 3000), 1e-11) << length;
  }
}

TEST(StretchingForce, ConservesTheEnergyForTenSeconds) {
  LONG_VERIFICATION();
  EXPECT_LT(drift(curved_body(), 1.0 / 176400, 1764000), 1e-10);
}

TEST(StretchingForce, FlatBodyHasThePitchOfDuffingsEquation) {
  const double w = 1000.0;
  const double c = 700.0;
  const double amplitude = 1.0;
  // Nayfeh and Mook, Nonlinear Oscillations, 2.1: the period is 4 K(k)/sqrt(w^2 + cubic amplitude^2).
  const double cubic = 2 * c * c;
  const double square = w * w + cubic * amplitude * amplitude;
  const double exact =
      4 * std::comp_ellint_1(std::sqrt(cubic * amplitude * amplitude / (2 * square))) / std::sqrt(square);
  const auto error = [&](double length) {
    Vibration body(flat_body(w, c), length, Eigen::Array<double, 1, 1>(amplitude));
    return std::abs(period(body, 40) / exact - 1);
  };
  const double coarse = error(4e-5);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(coarse / error(2e-5), 4.0, 0.2) << "second order";
}

TEST(StretchingForce, VanishesForSmallVibrations) {
  ModalBasis small = curved_body();
  small.stretching = {};
  const Eigen::Array3d places = 1e-6 * Eigen::Array3d(1.0, -0.7, 0.4);
  Vibration with(curved_body(), 1e-4, places);
  Vibration without(small, 1e-4, places);
  for (int n = 0; n < 1000; ++n) {
    with.advance();
    without.advance();
  }
  // Of first order in the amplitude.
  EXPECT_LT((with.coordinates.places() - without.coordinates.places()).abs().maxCoeff(), 1e-10);
}

TEST(StretchingForce, DampedVibrationDiesAway) {
  ModalBasis basis = curved_body();
  basis.decay_rates = {20, 40, 60};
  Vibration body(basis, 5e-5, Eigen::Array3d(1.0, -0.7, 0.4));
  body.advance();
  double before = body.discrete_energy();
  for (int n = 0; n < 2000; ++n) {
    body.advance();
  }
  EXPECT_LT(body.discrete_energy(), std::exp(-2 * 20 * 0.1 * 0.8) * before);
  EXPECT_GT(body.discrete_energy(), 0.0);
}

TEST(StretchingForce, EnergyIsTheWorkAgainstTheForce) {
  StretchingForce force(curved_body().stretching);
  const Eigen::ArrayXd places = Eigen::Array3d(0.8, -0.3, 0.5);
  const Eigen::ArrayXd way = Eigen::Array3d(0.2, 0.9, -0.4);
  const auto energy_at = [&](double part) {
    force.go_to(places + part * way);
    return force.energy();
  };
  const double slope = (energy_at(0.01) - energy_at(-0.01)) / 0.02;
  force.go_to(places);
  EXPECT_NEAR(slope / -(force.force() * way).sum(), 1.0, 1e-3);
}

TEST(StretchingForce, StoredEnergyStaysThatOfTheStretching) {
  Vibration body(curved_body(), 5e-5, Eigen::Array3d(1.0, -0.7, 0.4));
  StretchingForce there(body.basis.stretching);
  constexpr int steps = 100000;
  double drift = 0.0;
  for (int n = 0; n < steps; ++n) {
    body.advance();
    if (n >= steps / 2) {  // the steps differ by more, to and fro
      there.go_to((body.before + body.coordinates.places()) / 2);
      drift += body.coordinates.stored_energy() - there.energy();
    }
  }
  EXPECT_LT(std::abs(drift) / (steps / 2), 3e-4 * body.discrete_energy());
}

// V = w^2 q^2/2 + a c q^3 + c^2 q^4/2 has a second equilibrium, where w^2 + 3 a c q + 2 c^2 q^2 is zero.
TEST(StretchingForce, ShellThatSnappedThroughVibratesAboutItsOtherEquilibrium) {
  constexpr double w = 1000, a = 999.9, c = 500;
  ModalBasis basis = flat_body(w, c);
  basis.stretching.linear = {a};
  const double other = (-3 * a - std::sqrt(9 * a * a - 8 * w * w)) / (4 * c);
  const double frequency = std::sqrt(w * w + 6 * a * c * other + 6 * c * c * other * other);
  const double amplitude = 1e-3;
  constexpr double length = 1e-5;
  Vibration body(basis, length, Eigen::Array<double, 1, 1>(other + amplitude));
  double largest_error = 0.0;
  for (int n = 1; n <= 2000; ++n) {
    body.advance();
    const double expected = amplitude * std::cos(frequency * n * length);
    largest_error = std::max(largest_error, std::abs(body.coordinates.places()[0] - other - expected));
  }
  EXPECT_LT(largest_error, 0.03 * amplitude);
}

/// Places of the modes by Runge and Kutta's method of fourth order.
Eigen::VectorXd reference(const ModalBasis& basis, Eigen::VectorXd q, double time) {
  const auto modes = q.size();
  const Eigen::Map<const Eigen::VectorXd> w(basis.frequencies.data(), modes);
  const auto acceleration = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd result = -w.cwiseAbs2().cwiseProduct(at);
    for (std::size_t n = 0; n < basis.stretching.terms(); ++n) {
      const Eigen::Map<const Eigen::VectorXd> linear(&basis.stretching.linear[n * modes], modes);
      const Eigen::Map<const Eigen::MatrixXd> quadratic(&basis.stretching.quadratic[n * modes * modes], modes, modes);
      const Eigen::VectorXd y = quadratic * at;
      result -= 2 * (linear.dot(at) + y.dot(at)) * y + y.dot(at) * linear;
    }
    return result;
  };
  constexpr int steps = 20000;
  const double h = time / steps;
  Eigen::VectorXd v = 0.0 * q;
  for (int step = 0; step < steps; ++step) {
    support::runge_kutta_step(acceleration, h, q, v);
  }
  return q;
}

TEST(StretchingForce, MovesTheModesAsAnotherMethodSays) {
  constexpr int steps = 4000;
  constexpr double length = 5e-6;
  const Eigen::Array3d struck(1.0, -0.7, 0.4);
  Vibration body(curved_body(), length, struck);
  for (int n = 0; n < steps; ++n) {
    body.advance();
  }
  const Eigen::VectorXd expected = reference(body.basis, struck, steps * length);
  EXPECT_LT((body.coordinates.places().matrix() - expected).norm(), 1e-3 * struck.matrix().norm());
}

}  // namespace
}  // namespace idiophone::modal_bodies

// Modes that stretch their body: what is conserved, and an independent solution of the same equations.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "idiophone/instruments/resonators/point_contacts.hpp"
#include "runge_kutta.hpp"
#include "stretched_body.hpp"

namespace idiophone::resonators {
namespace {

const Eigen::Vector3d velocities(1000.0, -1200.0, 1600.0);  // they stretch it by as much as they bend it

/// Positions in each audio sample by Runge and Kutta's method of fourth order, in steps of an eighth of a sample.
std::vector<Eigen::VectorXd> reference(const StretchedBody& body, const Eigen::VectorXd& struck, int samples) {
  const Eigen::VectorXd w =
      2 * std::numbers::pi * Eigen::Map<const Eigen::VectorXd>(body.frequencies.data(), std::ssize(body.frequencies));
  const auto acceleration = [&](const Eigen::VectorXd& q) -> Eigen::VectorXd {
    return body.force_at(q) - w.cwiseAbs2().cwiseProduct(q);
  };
  constexpr int parts = 8;
  const double h = 1.0 / (rate * parts);
  Eigen::VectorXd q = 0.0 * struck, v = struck;
  std::vector<Eigen::VectorXd> found;
  for (int part = 0; part < samples * parts; ++part) {
    if (part % parts == 0) {
      found.push_back(q);
    }
    support::runge_kutta_step(acceleration, h, q, v);
  }
  return found;
}

TEST(StretchedModes, ConserveTheEnergyHoweverLargeItIs) {
  const StretchedBody body;
  const auto turns = in_groups(body.turns());
  for (const double amplitude : {1e-6, 1e-3, 1.0, 30.0, 1e4}) {
    StretchedModes stretching = body.modes();
    std::vector<ModeGroup> states = StretchedBody::struck(amplitude * velocities);
    const double start = body.energy_of(states);
    double worst = 0.0;
    for (int sample = 0; sample < 3000; ++sample) {
      advance(stretching, states, turns);
      const double modes = body.energy_of(states);
      worst = std::max(worst, std::abs((modes + stretching.stored_energy()) / start - 1));
      EXPECT_LT(modes, 3.001 * start) << amplitude;
    }
    EXPECT_LT(worst, 1e-11) << amplitude;
  }
}

TEST(StretchedModes, DampedModesNeverGainEnergy) {
  StretchedBody body;
  body.decay = 30.0;
  const auto turns = in_groups(body.turns());
  StretchedModes stretching = body.modes();
  std::vector<ModeGroup> states = StretchedBody::struck(2.0 * velocities);
  const double start = body.energy_of(states);
  double before = start;
  for (int sample = 0; sample < 4000; ++sample) {
    advance(stretching, states, turns);
    const double energy = body.energy_of(states) + stretching.stored_energy();
    EXPECT_LE(energy, before + 1e-12 * start);
    before = energy;
  }
  EXPECT_LT(before, std::exp(-2 * 30.0 * 4000 / rate * 0.8) * start);
}

TEST(StretchedModes, MoveAsAnotherMethodSays) {
  const StretchedBody body;
  const auto turns = in_groups(body.turns());
  StretchedModes stretching = body.modes();
  std::vector<ModeGroup> states = StretchedBody::struck(velocities);
  double worst = 0.0;
  for (const Eigen::VectorXd& places : reference(body, velocities, 1000)) {
    worst = std::max(worst, (body.places_of(states) - places).cwiseAbs().maxCoeff());
    advance(stretching, states, turns);
  }
  EXPECT_LT(worst, 3e-3);  // 0.3 % after 3 to 13 periods: a cent is 0.06 % of a period
}

TEST(StretchedModes, KnowTheirLargestRotation) {
  const StretchedBody body;
  const auto turns = in_groups(body.turns());
  const Eigen::Map<const Eigen::Matrix3d> rotation(body.rotation.data());
  StretchedModes stretching = body.modes();
  EXPECT_EQ(stretching.largest_rotation(), 0.0);
  std::vector<ModeGroup> states = StretchedBody::struck(velocities);
  double largest = 0.0;
  for (int sample = 0; sample < 4000; ++sample) {
    const Eigen::VectorXd places = body.places_of(states);
    largest = std::max(largest, std::sqrt(places.dot(rotation * places)));
    advance(stretching, states, turns);
  }
  EXPECT_NEAR(stretching.largest_rotation() / largest, 1.0, 0.02);  // it is not watched in every sample
}

// V = w^2 q^2/2 + a c q^3 + c^2 q^4/2 has a second equilibrium, where w^2 + 3 a c q + 2 c^2 q^2 is zero.
TEST(StretchedModes, ShellThatSnapsThroughVibratesAboutItsOtherEquilibrium) {
  constexpr double w = 1000, a = 999.9, c = 500;
  const StretchedBody body{.frequencies = {w / (2 * std::numbers::pi)}, .decay = 40, .linear = {a}, .quadratic = {c}};
  const double other = (-3 * a - std::sqrt(9 * a * a - 8 * w * w)) / (4 * c);
  const double stiffness = w * w + 6 * a * c * other + 6 * c * c * other * other;
  const auto turns = in_groups(body.turns());
  StretchedModes stretching = body.modes();
  std::vector<ModeGroup> states = StretchedBody::struck(Eigen::VectorXd::Constant(1, -600));  // 500 pass the summit
  int passages = 0;
  double before = 0.0;
  for (int sample = 0; sample < rate / 5; ++sample) {
    advance(stretching, states, turns);
    const double place = body.places_of(states)[0] - other;
    passages += sample > rate / 10 && place * before < 0;
    before = place;
  }
  EXPECT_NEAR(passages, std::sqrt(stiffness) / std::numbers::pi / 10, 1.0);
}

TEST(StretchedModes, ScaleWithTheSizeOfTheBody) {
  const double size = 1.3;
  const StretchedBody body;
  StretchedBody larger;
  for (double& frequency : larger.frequencies) {
    frequency /= size;
  }
  const auto turns = in_groups(larger.turns());
  StretchedModes retuned = body.modes();
  retuned.retune(turns, size);
  for (double& value : larger.linear) {
    value /= size;
  }
  for (double& value : larger.quadratic) {
    value *= std::pow(size, -3.5);
  }
  for (double& value : larger.rotation) {
    value *= std::pow(size, -5);
  }
  StretchedModes made = larger.modes();
  std::vector<ModeGroup> states = StretchedBody::struck(velocities), others = states;
  for (int sample = 0; sample < 100; ++sample) {
    advance(retuned, states, turns);
    advance(made, others, turns);
  }
  EXPECT_LT((larger.places_of(states) - larger.places_of(others)).norm(), 1e-6);
  EXPECT_NEAR(retuned.largest_rotation() / made.largest_rotation(), 1.0, 1e-5);
}

/// Between a mode's point and something that does not move.
class Spring : public Contact {
 public:
  explicit Spring(double stiffness) : stiffness_(stiffness) {}
  [[nodiscard]] double force(double free, double compliance) const override {
    return -stiffness_ * (length_ + free / 2) / (1 + stiffness_ * compliance / 2);
  }
  void advance(double way, double /*force*/) override { length_ += way; }
  [[nodiscard]] double energy() const { return stiffness_ * length_ * length_ / 2; }

 private:
  double stiffness_;
  double length_ = 0.0;
};

TEST(StretchedModes, ExchangeEnergyWithContacts) {
  const StretchedBody body;
  ResonatorBank bank(body.turns(), body.modes());
  std::vector<Complex> displacement, by_mean;
  for (const double frequency : body.frequencies) {
    const Resonator resonator(DampedOscillator(frequency, 0.0), rate);
    displacement.push_back(0.8 * resonator.displacement);
    by_mean.push_back(0.8 * resonator.by_mean);
  }
  ContactPoint point{
      .displacement = in_groups(displacement), .by_mean = in_groups(by_mean), .by_slope = {}, .lowest = 1e3};
  point.by_slope.resize(1);
  PointContacts contacts(rate);
  Spring first(3e6), second(1e5);
  std::vector<double> sound(ResonatorBank::most_samples);
  const std::vector<ModeGroup> gains(1);
  const ForcePiece push{.mean = 3e4, .slope = 0.0};
  const std::vector<ForcePiece> force(64, push);
  const std::vector<ModeGroup> by_force = in_groups(by_mean), no_slope(1);
  const std::vector<Drive> drives = {{.force = force, .by_mean = by_force, .by_slope = no_slope}};
  bank.advance(drives, contacts, gains, 1, sound);  // a push, after which the springs come
  contacts.add(first, point);
  contacts.add(second, point);
  const auto energy = [&] {
    const std::vector<ModeGroup> states(bank.states().begin(), bank.states().end());
    return body.energy_of(states) + bank.stretching_energy() + first.energy() + second.energy();
  };
  const double start = energy();
  for (int piece = 0; piece < 50; ++piece) {
    bank.advance({}, contacts, gains, 1, sound);
    EXPECT_NEAR(energy(), start, 1e-10 * start);
  }
  EXPECT_GT(first.energy() + second.energy(), 1e-4 * start);
}

// The pressure of a velocity v whose mode of the frequency w is heard by R + i X is X v'/w - R v''/w^2.
TEST(StretchedModes, SoundByTheirAccelerationsAndTheChangeOfThem) {
  const StretchedBody body{
      .frequencies = {160, 270, 1000}, .linear = {0, 0, 6000}, .quadratic = {50, 0, 0, 0, 0, 0, 0, 0, 0}};
  constexpr double real = 20.0, imaginary = 2.0, w = 2 * std::numbers::pi * 1000;
  const std::vector<ModeGroup> gains = in_groups(std::vector<Complex>{0.0, 0.0, {real, imaginary}});
  ResonatorBank bank(body.turns(), body.modes());
  const std::vector<ForcePiece> force(1, {.mean = 3000.0 * rate, .slope = 0.0});
  const std::vector<ModeGroup> none(1);
  const std::vector<ModeGroup> lowest = in_groups(std::vector<Complex>{1.0 / rate, 0.0, 0.0});
  PointContacts nothing(rate);
  std::vector<double> sound, velocity, piece(1);
  for (int sample = 0; sample < rate / 10; ++sample) {
    const Drive blow{.force = force, .by_mean = lowest, .by_slope = none};
    velocity.push_back(bank.state(2).real());
    bank.advance(sample == 0 ? std::span(&blow, 1) : std::span<const Drive>{}, nothing, gains, 1, piece);
    sound.push_back(piece[0]);
  }
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 10; i + 1 < sound.size(); ++i) {
    const double acceleration = (velocity[i + 1] - velocity[i - 1]) * rate / 2;
    const double change = (velocity[i + 1] - 2 * velocity[i] + velocity[i - 1]) * rate * rate;
    const double expected = imaginary * acceleration / w - real * change / (w * w);
    error = std::max(error, std::abs(sound[i] - expected));
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_LT(error, 0.02 * largest);
}

TEST(StretchedModes, AreLinearWhereTheyAreSmall) {
  const StretchedBody body;
  ResonatorBank with(body.turns(), body.modes());
  ResonatorBank without(body.turns());
  const std::vector<ForcePiece> force(64, {.mean = 0.01, .slope = 0.0});
  const std::vector<ModeGroup> by_mean = in_groups(std::vector<Complex>(3, 1.0 / rate)), none(1);
  const std::vector<Drive> drives = {{.force = force, .by_mean = by_mean, .by_slope = none}};
  PointContacts nothing(rate);
  std::vector<double> sound(ResonatorBank::most_samples);
  with.advance(drives, nothing, by_mean, 1, sound);
  without.advance(drives, by_mean, 1, sound);
  EXPECT_TRUE(with.stretches({}));
  with.silence();
  EXPECT_FALSE(with.stretches({})) << "it counts no longer";
  for (std::size_t mode = 0; mode < 3; ++mode) {
    EXPECT_LT(std::abs(with.state(mode) - without.state(mode)), 1e-5 * std::abs(without.state(mode)));
  }
}

}  // namespace
}  // namespace idiophone::resonators

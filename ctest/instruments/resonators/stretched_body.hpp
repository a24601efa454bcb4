#pragma once
// Modes that stretch a curved body by two strains, and their energy in double precision.

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "rate.hpp"

namespace idiophone::resonators {

/// Its stretching is of second order as of first: it softens and hardens.
struct StretchedBody {
  std::vector<double> frequencies = {160, 270, 640};  // Hz
  double decay = 0.0;                                 // 1/s
  std::vector<double> linear = {500, -300, 100, 0, 800, 2000};
  std::vector<double> quadratic = {900,  200, -100, 200, 500, 50,  -100, 50,  1500,
                                   -300, 400, 0,    400, 700, 300, 0,    300, 100};

  std::vector<double> rotation = {40, 10, 0, 10, 90, -20, 0, -20, 160};

  [[nodiscard]] std::vector<Complex> turns() const {
    std::vector<Complex> turns;
    for (const double frequency : frequencies) {
      turns.push_back(Resonator(DampedOscillator(frequency, decay), rate).turn);
    }
    return turns;
  }

  [[nodiscard]] StretchingEnergy energy() const { return {linear, quadratic, frequencies.size()}; }

  [[nodiscard]] StretchedModes modes() const { return {energy(), rotation, in_groups(turns()), rate}; }

  /// z of the modes that were just struck.
  /// @param velocities  kg^1/2 m/s
  [[nodiscard]] static std::vector<ModeGroup> struck(const Eigen::VectorXd& velocities) {
    return in_groups(std::vector<Complex>(velocities.begin(), velocities.end()));
  }

  [[nodiscard]] Eigen::VectorXd places_of(const std::vector<ModeGroup>& states) const {
    Eigen::VectorXd places(std::ssize(frequencies));
    for (Eigen::Index mode = 0; mode < places.size(); ++mode) {
      const DampedOscillator oscillator(frequencies[static_cast<std::size_t>(mode)], decay);
      places[mode] = value_of(states[0], static_cast<std::size_t>(mode)).imag() / oscillator.damped;
    }
    return places;
  }

  /// Of the modes without stretching, J.
  [[nodiscard]] double energy_of(const std::vector<ModeGroup>& states) const {
    double energy = 0.0;
    for (std::size_t mode = 0; mode < frequencies.size(); ++mode) {
      const DampedOscillator oscillator(frequencies[mode], decay);
      const Complex z = value_of(states[0], mode);
      const double velocity = (oscillator.velocity() * z).real();
      const double place = (oscillator.displacement() * z).real();
      energy += (velocity * velocity + std::norm(oscillator.exponent()) * place * place) / 2;
    }
    return energy;
  }

  /// The force of stretching on the modes, N/kg^1/2.
  [[nodiscard]] Eigen::VectorXd force_at(const Eigen::VectorXd& places) const {
    const auto modes = places.size();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(modes);
    for (std::size_t term = 0; term < linear.size() / frequencies.size(); ++term) {
      const Eigen::Map<const Eigen::VectorXd> a(&linear[term * frequencies.size()], modes);
      const Eigen::Map<const Eigen::MatrixXd> h(&quadratic[term * frequencies.size() * frequencies.size()], modes,
                                                modes);
      const Eigen::VectorXd y = h * places;
      force -= 2 * (a.dot(places) + y.dot(places)) * y + y.dot(places) * a;
    }
    return force;
  }
};

/// An audio sample of a body on which nothing else acts.
inline void advance(StretchedModes& stretching, std::vector<ModeGroup>& states, const std::vector<ModeGroup>& turns) {
  const std::vector<ModeGroup> before = states;
  for (std::size_t mode = 0; mode < modes_in_group; ++mode) {
    const std::size_t p = mode / modes_in_pack, lane = mode % modes_in_pack;
    const Complex z = value_of(before[0], mode) * value_of(turns[0], mode);
    states[0].real[p][lane] = z.real();
    states[0].imaginary[p][lane] = z.imag();
  }
  stretching.find_force(before, states);
  stretching.end(states, stretching.free_root());
}

}  // namespace idiophone::resonators

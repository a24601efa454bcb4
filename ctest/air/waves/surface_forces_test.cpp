// The force of the air on surfaces, against the exact one on spheres, and its work against the sound that leaves.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "idiophone/air/waves/surface_coupling.hpp"
#include "ranks.hpp"
#include "ringing.hpp"

namespace idiophone::waves {
namespace {

constexpr double width = 1e-4;   // of the pulse of velocity, s
constexpr double middle = 6e-4;  // of the pulse, s
constexpr int rate = 44100;      // of which the steps are a multiple, 1/s

/// A solid whose velocity is a shape times a pulse, and what the air does to it.
class Pulsed {
 public:
  Pulsed(const radiation::Solid& solid, double cell, const NormalVelocity& shape)
      : positions_(positions_of(solid)),
        shape_(shape_of(solid, shape)),
        plan_(plan_for(solid, cell)),
        field_(Division(plan_.grid, 1), plan_.courant, MPI_COMM_SELF) {
    const Obstruction obstruction{solid.triangles, positions_};
    CutCells cells(field_.subdomain(), obstruction, plan_.courant);
    coupling_ = SurfaceCoupling(field_.subdomain(), obstruction, shape_.size(), cells, plan_.courant);
    of_nodes_.resize(cells.nodes().size());
    field_.set_surfaces(std::move(cells));
  }

  /// One step. @return the force in it, as the work over the mean velocity that the shape is multiplied by, N
  double advance() {
    field_.forecast(of_nodes_);
    const double change = impedance * (pulse(time_ + step() / 2.0) - pulse(time_ - step() / 2.0));
    double force = 0.0;
    for (const ForceShare& share : coupling_.forces(of_nodes_)) {
      const double here = shape_[share.triangle];
      for (std::size_t k = 0; k < 3; ++k) {
        force += here * (share.force.at(k) + share.resistance.at(k) * change * here);
      }
    }
    std::vector<float> changes;
    for (const float here : shape_) {
      changes.insert(changes.end(), 3, static_cast<float>(change * here));
    }
    coupling_.add(changes, of_nodes_);
    field_.step(of_nodes_);
    time_ += step();
    return force;
  }

  [[nodiscard]] double step() const { return 1.0 / (rate * plan_.steps); }
  /// At which the field is, s.
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] static double pulse(double time) {
    const double x = (time - middle) / width;
    return std::exp(-0.5 * x * x);
  }
  [[nodiscard]] const WaveField& field() const { return field_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }

 private:
  static Plan plan_for(const radiation::Solid& solid, double cell) {
    Wishes wishes{.low = solid.vertices[0], .high = solid.vertices[0], .cell = cell, .rate = rate, .floor = {}};
    for (const Vector3& vertex : solid.vertices) {
      wishes.low = wishes.low.cwiseMin(vertex);
      wishes.high = wishes.high.cwiseMax(vertex);
    }
    return make_plan(wishes);
  }

  std::vector<float> positions_, shape_;
  Plan plan_;
  WaveField field_;
  SurfaceCoupling coupling_;
  std::vector<float> of_nodes_;
  double time_ = 0.0;
};

/// What leaves through the box around the surfaces.
class EnergyFlow {
 public:
  explicit EnergyFlow(const Pulsed& pulsed)
      : box_(pulsed.field(), pulsed.plan().enclosure), velocity_(box_.patches()) {}

  /// Adds the energy that left in the last step, J.
  void add(const Pulsed& pulsed) {
    const surface::Emission& air = box_.emission();
    for (std::size_t patch = 0; patch < velocity_.size(); ++patch) {
      const double change = -air.pressure_gradient[patch] * pulsed.step() * speed / impedance;  // m/s
      energy_ += air.area[patch] * air.surface_pressure[patch] * (velocity_[patch] + change / 2.0) * pulsed.step();
      velocity_[patch] += change;
    }
  }
  [[nodiscard]] double energy() const { return energy_; }

 private:
  EnclosingBox box_;
  std::vector<double> velocity_;  // outwards, half a step before the pressure, m/s
  double energy_ = 0.0;
};

/// Force over velocity of a sphere, exp(i w t): order 0 pulsates, order 1 oscillates along an axis. N s/m
Complex exact_impedance(int order, double radius, double frequency) {
  const double k = 2.0 * std::numbers::pi * frequency / speed;
  const auto hankel = [](int l, double x) { return Complex(std::sph_bessel(l, x), -std::sph_neumann(l, x)); };
  const Complex slope = hankel(order, k * radius) * (order / (k * radius)) - hankel(order + 1, k * radius);
  return Complex(0.0, -impedance) * hankel(order, k * radius) / slope * 4.0 * std::numbers::pi * radius * radius /
         (2.0 * order + 1.0);
}

ON_RANKS(1);

TEST(SurfaceForces, AreThoseOfASphereThatPulsatesOrOscillates) {
  constexpr double radius = 0.1;  // m
  const Vector3 axis = Vector3(1, 2, 2).normalized();
  const auto sphere = radiation::icosphere(radius, 8);
  for (const int order : {0, 1}) {
    Pulsed pulsed(sphere, 0.0125,
                  [&](const Vector3&, const Vector3& normal) { return order == 0 ? 1.0 : normal.dot(axis); });
    const std::array frequencies = {300.0, 600.0, 1200.0};
    std::array<Complex, frequencies.size()> force{}, velocity{};
    while (pulsed.time() < 0.008) {
      const double half_way = pulsed.time() + pulsed.step() / 2.0;
      const double now = pulsed.advance();
      for (std::size_t f = 0; f < frequencies.size(); ++f) {
        const Complex turn = std::exp(Complex(0.0, -2.0 * std::numbers::pi * frequencies.at(f) * half_way));
        force.at(f) += now * turn;
        velocity.at(f) += Pulsed::pulse(half_way) * turn;
      }
    }
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
      const Complex exact = exact_impedance(order, radius, frequencies.at(f));
      const Complex found = force.at(f) / velocity.at(f);
      EXPECT_NEAR(found.real() / exact.real(), 1.0, 0.03) << order << " " << frequencies.at(f);
      EXPECT_LT(std::abs(found / exact - 1.0), 0.05) << order << " " << frequencies.at(f);
    }
  }
}

/// The work of the forces over the energy of the sound that leaves.
double balance(const radiation::Solid& solid, double cell, const NormalVelocity& shape) {
  Pulsed pulsed(solid, cell, shape);
  EnergyFlow flow(pulsed);
  double work = 0.0;
  while (pulsed.time() < 0.008) {
    const double velocity = Pulsed::pulse(pulsed.time() + pulsed.step() / 2.0);
    work += pulsed.advance() * velocity * pulsed.step();
    flow.add(pulsed);
  }
  return work / flow.energy();
}

TEST(SurfaceForces, WorkAsMuchAsTheSoundThatLeaves) {
  EXPECT_NEAR(balance(radiation::icosphere(0.05, 4), 0.01,
                      [](const Vector3&, const Vector3& normal) { return normal.dot(Vector3::UnitX()); }),
              1.0, 0.02);
  EXPECT_NEAR(balance(radiation::box(Vector3(0.2, 0.2, 0.004), {8, 8, 1}), 0.01,
                      [](const Vector3&, const Vector3& normal) { return normal[2]; }),
              1.0, 0.02);
}

}  // namespace
}  // namespace idiophone::waves

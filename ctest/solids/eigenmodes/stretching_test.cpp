// Stretching at large amplitude: strains against the kernels of the elements, plates and shells against theory.

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "fewest_terms.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "mapped_block.hpp"
#include "ranks.hpp"
#include "strain_space.hpp"

namespace idiophone::eigenmodes {
namespace {

/// A field without pattern that strains a body by about 10 %. [3 x nodes]
Eigen::VectorXd wild_field(const mesh::Mesh& mesh) {
  Eigen::VectorXd field(3 * std::ssize(mesh.nodes));
  for (Eigen::Index c = 0; c < field.size(); ++c) {
    field[c] = 1e-3 * std::sin(1.7 * static_cast<double>(c * c));
  }
  return field;
}

double elastic_energy(const VibratingBody& body, const mesh::Part& part, const Eigen::VectorXd& field) {
  const solid::Solid solid(part.bodies[0], part.reference, body.scene.materials[0]);
  std::vector<solid::NodeState> state(part.reference.size());
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      state[node].displacement[axis] = field[static_cast<Eigen::Index>(3 * node + axis)];
    }
  }
  std::vector<double> energy(part.bodies[0].element_ids.size());
  solid.elastic_energy(state, energy);
  double sum = 0.0;
  for (const double of_element : energy) {
    sum += of_element;
  }
  return sum;
}

/// The modal basis of a body with large amplitudes.
modal_bodies::ModalBasis stretched(VibratingBody& body, int count, double tolerance) {
  body.scene.bodies[0].modal =
      scene::ModalModel{.up_to = {}, .count = count, .stretching_tolerance = tolerance, .where = {}};
  return modal_basis(body.scene, 0, body.mesh, {});
}

/// Energy of stretching of one mode alone: c q^3 + d q^4.
struct OneMode {
  double cubic = 0.0;
  double quartic = 0.0;

  OneMode(const modal_bodies::Stretching& stretching, std::size_t modes, std::size_t mode) {
    for (std::size_t n = 0; n < stretching.terms(); ++n) {
      const double a = stretching.linear[n * modes + mode];
      const double h = stretching.quadratic[(n * modes + mode) * modes + mode];
      cubic += a * h;
      quartic += h * h / 2;
    }
  }
};

/// A square plate of hexahedra, simply supported: the middle of its rim is held.
VibratingBody supported_plate(int cells, double side, double thickness) {
  VibratingBody plate = block(element::hex(4, 2), {side, side, thickness}, {cells, cells, 1});
  for (const Index node : plate.mesh.groups.at("rim")) {
    if (std::abs(plate.mesh.nodes[node][2] - thickness / 2) < 1e-6 * thickness) {
      plate.mesh.groups["edge"].push_back(node);
    }
  }
  plate.fix("edge");
  return plate;
}

ON_RANKS(1);

TEST(StrainSpace, HasTheEnergyOfTheElements) {
  for (const element::Type type : {element::tet4, element::tet10, element::hex(3, 2)}) {
    const MappedBlock bent{.name = "bent", .size = {0.1, 0.04, 0.02}, .place = [](const Vector3& x) {
                             return Vector3(x[0], x[1], x[2] + 2 * x[0] * x[0]);
                           }};
    const VibratingBody body = bent.body(type, {3, 2, 1});
    const mesh::Part part = support::whole_part(body.mesh);
    const solid::Elasticity elasticity = solid::elasticity(body.scene.materials[0]);
    const StrainSpace space(part, std::array{std::vector{stiffness_matrix(elasticity)}});
    const Eigen::VectorXd field = wild_field(body.mesh);
    const double found = (space.linear(field) + space.quadratic(field)).squaredNorm() / 2;
    EXPECT_NEAR(found / elastic_energy(body, part, field), 1.0, 1e-12) << element::name(type);

    const Eigen::VectorXd strain = space.quadratic(field);
    EXPECT_NEAR(space.forces(strain).col(0).dot(field) / strain.dot(space.linear(field).col(0)), 1.0, 1e-12);
    const Eigen::MatrixXd product = space.products(strain, field).front();
    EXPECT_NEAR(product(0, 0) / strain.squaredNorm(), 1.0, 1e-12);
  }
}

TEST(StrainSpace, RotationOfARigidTurnIsItsAngle) {
  const VibratingBody body = block(element::tet10, {0.1, 0.04, 0.02}, {2, 1, 1});
  const mesh::Part part = support::whole_part(body.mesh);
  const StrainSpace space(part, std::array{std::vector{stiffness_matrix(solid::elasticity(body.scene.materials[0]))}});
  const Vector3 turn(0.03, -0.02, 0.05);
  Eigen::VectorXd field(3 * std::ssize(part.reference));
  for (std::size_t node = 0; node < part.reference.size(); ++node) {
    field.segment<3>(static_cast<Eigen::Index>(3 * node)) = turn.cross(part.reference[node]);
  }
  EXPECT_NEAR(space.rotations(field)(0, 0), turn.squaredNorm(), 1e-12);
}

TEST(Stretching, SupportedPlateHardensAsPlateTheorySays) {
  const double side = 0.2;
  const double thickness = 0.001;
  VibratingBody plate = supported_plate(2, side, thickness);
  const modal_bodies::ModalBasis basis = stretched(plate, 1, 1e-6);
  const OneMode mode(basis.stretching, 1, 0);
  EXPECT_LT(std::abs(mode.cubic), 1e-6 * std::sqrt(mode.quartic) * basis.frequencies[0]) << "a flat plate";
  double largest = 0.0;  // displacement of q = 1
  for (const double component : basis.shapes) {
    largest = std::max(largest, std::abs(component));
  }
  // One mode, immovable edges, by plate theory (docs/method/large_amplitudes.md, Measured).
  const std::vector<std::pair<double, double>> theory = {
      {0.2, 1.0196}, {0.4, 1.0760}, {0.6, 1.1633}, {0.8, 1.2746}, {1.0, 1.4041}};
  for (const auto& [amplitude, expected] : theory) {
    const double q = amplitude * thickness / largest;
    // q'' + w^2 q + 4 d q^3 = 0 (Nayfeh and Mook, Nonlinear Oscillations, 2.1).
    const double hardening = 4 * mode.quartic * q * q / std::pow(basis.frequencies[0], 2);
    const double ratio = std::numbers::pi * std::sqrt(1 + hardening) /
                         (2 * std::comp_ellint_1(std::sqrt(hardening / (2 * (1 + hardening)))));
    EXPECT_NEAR(ratio, expected, 0.01 * (expected - 1)) << amplitude;
  }
}

TEST(Stretching, ClampedCapSoftens) {
  // A shallow spherical cap on a square, as high as it is thick.
  const double radius = 2.0;
  const double side = 0.1;
  const MappedBlock cap{.name = "cap", .size = {side, side, 0.0006}, .place = [=](const Vector3& x) {
                          const double r = std::hypot(x[0] - side / 2, x[1] - side / 2);
                          return Vector3(x[0], x[1], x[2] - r * r / (2 * radius));
                        }};
  VibratingBody body = cap.body(element::hex(4, 2), {2, 2, 1});
  body.fix("rim");
  const modal_bodies::ModalBasis basis = stretched(body, 1, 1e-6);
  const OneMode mode(basis.stretching, 1, 0);
  // w^2 q + 3 c q^2 + 4 d q^3: the pitch changes by 3/8 (4 d)/w^2 - 5/12 (3 c)^2/w^4 times the square of the amplitude
  // (Nayfeh and Mook, 2.3.1).
  const double square = std::pow(basis.frequencies[0], 2);
  EXPECT_LT(1.5 * mode.quartic / square - 3.75 * std::pow(mode.cubic / square, 2), 0.0);
  // It softens to the side on which the elements have less energy. Static stretching has no part in that.
  const mesh::Part part = support::whole_part(body.mesh);
  const Eigen::Map<const Eigen::VectorXd> shape(basis.shapes.data(), std::ssize(basis.shapes));
  const double q = 0.0006 / shape.cwiseAbs().maxCoeff();
  const double difference = elastic_energy(body, part, q * shape) - elastic_energy(body, part, -q * shape);
  EXPECT_NEAR(2 * mode.cubic * q * q * q / difference, 1.0, 0.01);
}

TEST(Stretching, TakesMoreStrainsForLess) {
  VibratingBody plate = block(element::hex(3, 2), {0.2, 0.12, 0.002}, {2, 2, 1});
  const modal_bodies::Stretching rough = stretched(plate, 6, 1e-1).stretching;
  const modal_bodies::Stretching fine = stretched(plate, 6, 1e-4).stretching;
  EXPECT_LT(rough.terms(), fine.terms());
  EXPECT_LE(fine.terms(), 21U) << "pairs of modes";
  EXPECT_EQ(stretched(plate, 6, 1e-4).stretching.quadratic, fine.quadratic) << "the same bits again";
}

/// V of stretching at q, J.
double energy_at(const modal_bodies::Stretching& stretching, const Eigen::VectorXd& places) {
  double energy = 0.0;
  for (std::size_t n = 0; n < stretching.terms(); ++n) {
    const auto modes = static_cast<std::size_t>(places.size());
    const double a = places.dot(Eigen::Map<const Eigen::VectorXd>(&stretching.linear[n * modes], places.size()));
    const Eigen::Map<const Eigen::MatrixXd> h(&stretching.quadratic[n * modes * modes], places.size(), places.size());
    const double z = places.dot(h * places);
    energy += z * (a + z / 2);
  }
  return energy;
}

TEST(Stretching, HasTheSameEnergyInFewestTerms) {
  VibratingBody plate = block(element::hex(3, 2), {0.2, 0.12, 0.002}, {2, 2, 1});
  const modal_bodies::ModalBasis basis = stretched(plate, 6, 1e-4);
  const modal_bodies::Stretching same = in_fewest_terms(basis.stretching, basis.frequencies, 1e-14);
  const modal_bodies::Stretching fewer = in_fewest_terms(basis.stretching, basis.frequencies, 0.02);
  EXPECT_LT(fewer.terms(), basis.stretching.terms());
  EXPECT_GT(std::ranges::count(fewer.quadratic, 0.0), std::ssize(fewer.quadratic) / 3) << "pairs without energy";
  double whole = 0.0, kept = 0.0;
  for (int draw = 0; draw < 50; ++draw) {
    Eigen::VectorXd places(6);
    for (Eigen::Index mode = 0; mode < 6; ++mode) {
      places[mode] = std::sin(3.1 * (draw * 6.0 + static_cast<double>(mode)) * (draw + 1.0)) / basis.frequencies[mode];
    }
    const double energy = energy_at(basis.stretching, places);
    EXPECT_NEAR(energy_at(same, places), energy, 1e-6 * energy);
    whole += energy;
    kept += energy_at(fewer, places);
  }
  EXPECT_NEAR(kept / whole, 1.0, 0.04);
}

TEST(Stretching, IsThatOfTheFreeBodyOnSoftSupports) {
  const auto of_first_bending = [](double stiffness) {
    VibratingBody plate = block(element::hex(3, 2), {0.2, 0.12, 0.002}, {2, 2, 1});
    if (stiffness > 0) {
      const scene::PatchPlace place{.at = {0.03, 0.02, 0.0}, .radius = 0.05, .where = {}};
      plate.scene.bodies[0].supports = {{.name = "cord", .place = place, .stiffness = stiffness, .damping = 0.0}};
    }
    const int lower = stiffness > 0 ? 6 : 0;  // rigid motions that the support turns into modes
    const Modes found = plate.find({.count = lower + 1}, MPI_COMM_SELF);
    const modal_bodies::Stretching stretching = stretching_of(found, plate.scene, plate.part, plate.attachments, 1e-6);
    return OneMode(stretching, static_cast<std::size_t>(lower) + 1, static_cast<std::size_t>(lower)).quartic;
  };
  const double free = of_first_bending(0.0);
  EXPECT_NEAR(of_first_bending(20.0) / free, 1.0, 1e-3);
}

TEST(Stretching, IsRefusedAboutADeformedShape) {
  VibratingBody plate = block(element::hex(3, 2), {0.2, 0.12, 0.002}, {2, 2, 1});
  plate.fix("x0");
  plate.scene.bodies[0].prestress.emplace().stress(1, 1) = 1e6;
  const Modes found = plate.find({.count = 1}, MPI_COMM_SELF);
  EXPECT_THROW((void)stretching_of(found, plate.scene, plate.part, plate.attachments, 1e-6), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::eigenmodes

// Plates and shallow caps with free edges: how their pitch bends with the amplitude, against a code that shares nothing
// with the program.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "mapped_block.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double cap_side = 0.1, cap_thickness = 0.0005;

/// A square cap of a sphere without edges that are held.
/// @param rise  of its middle over those of its sides, thicknesses
modal_bodies::ModalBasis square_cap(double rise, int modes) {
  const MappedBlock cap{.name = "cap", .size = {cap_side, cap_side, cap_thickness}, .place = [=](const Vector3& x) {
                          const double r = std::hypot(x[0] - cap_side / 2, x[1] - cap_side / 2) / (cap_side / 2);
                          return Vector3(x[0], x[1], x[2] - rise * cap_thickness * r * r);
                        }};
  VibratingBody body = cap.body(element::hex(4, 2), {2, 2, 1});
  body.scene.bodies[0].modal =
      scene::ModalModel{.up_to = {}, .count = modes, .stretching_tolerance = 1e-6, .where = {}};
  return modal_basis(body.scene, 0, body.mesh, {});
}

/// By which share of itself the frequency of a mode rises if it vibrates by the thickness (root mean square over the
/// body), to second order: `bend` of scripts/library/ledger/shallow_shell.py.
double bend(const modal_bodies::ModalBasis& basis, Eigen::Index mode) {
  const auto modes = std::ssize(basis.frequencies);
  const Eigen::Map<const Eigen::ArrayXd> frequencies(basis.frequencies.data(), modes);
  const double square = frequencies[mode] * frequencies[mode];
  Eigen::ArrayXd drive = Eigen::ArrayXd::Zero(modes);
  double quartic = 0.0;
  for (std::size_t n = 0; n < basis.stretching.terms(); ++n) {
    const Eigen::Map<const Eigen::ArrayXd> a(&basis.stretching.linear[n * modes], modes);
    const Eigen::Map<const Eigen::MatrixXd> h(&basis.stretching.quadratic[n * modes * modes], modes, modes);
    drive += a * h(mode, mode) + 2 * a[mode] * h.col(mode).array();
    quartic += h(mode, mode) * h(mode, mode) / 2;
  }
  const Eigen::ArrayXd answers = frequencies.square().inverse() + 0.5 / (frequencies.square() - 4 * square);
  double mass = 0.0;
  for (const double of_node : basis.masses) {
    mass += of_node;
  }
  return (3 * quartic - (drive.square() * answers).sum()) / (2 * square) * mass * cap_thickness * cap_thickness;
}

ON_RANKS(1);

TEST(ShallowCaps, BendTheirPitchAsMarguerresEquationsSay) {
  // bend_of(mode, 12) of ShallowShell(square(), rise, 0.3, 10). The third mode is axisymmetric but for the corners: it
  // hardens on a plate, and softens on caps.
  const std::vector<std::pair<double, std::array<double, 3>>> theory = {
      {0.0, {0.422, 1.0473, 0.5802}}, {0.5, {0.6171, 0.9668, -0.0992}}, {0.75, {-0.1282, 0.9074, -0.6146}}};
  for (const auto& [rise, expected] : theory) {
    const modal_bodies::ModalBasis basis = square_cap(rise, 12);
    for (std::size_t mode = 0; mode < expected.size(); ++mode) {
      EXPECT_NEAR(bend(basis, static_cast<Eigen::Index>(mode)), expected.at(mode), 0.06) << rise << ", mode " << mode;
    }
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes

// Bodies whose symmetry gives several modes one frequency, against all eigenvalues of their dense matrices.

#include "eigensolver.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "inertia.hpp"
#include "operators.hpp"
#include "ranks.hpp"
#include "rigid_motions.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

using ::testing::HasSubstr;

constexpr int rigid = 6;

/// A cube has modes that come alone, in pairs and in triples.
VibratingBody cube() {
  return block(element::hex(2, 2), {0.1, 0.1, 0.1}, {2, 2, 2});
}

/// Operators of a body on the ranks of a communicator.
Operators operators_of(VibratingBody& body, MPI_Comm communicator) {
  (void)body.find({.count = 1}, communicator);  // its part
  return {body.scene, body.part, body.attachments, MassMatrix::lumped, communicator};
}

Eigen::MatrixXd dense(Mat matrix) {
  parallel::Handle<Mat> copy;
  parallel::petsc(MatConvert(matrix, MATDENSE, MAT_INITIAL_MATRIX, copy.out()));
  const PetscScalar* values = nullptr;
  PetscInt size = 0;
  parallel::petsc(MatGetSize(copy, &size, nullptr));
  parallel::petsc(MatDenseGetArrayRead(copy, &values));
  Eigen::MatrixXd result = Eigen::Map<const Eigen::MatrixXd>(values, size, size);
  parallel::petsc(MatDenseRestoreArrayRead(copy, &values));
  return result;
}

/// All eigenvalues, ascending, those of rigid motions included, (rad/s)^2.
Eigen::VectorXd all_eigenvalues(VibratingBody body) {
  const Operators operators = operators_of(body, MPI_COMM_SELF);
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(dense(operators.stiffness()),
                                                                   dense(operators.mass()), Eigen::EigenvaluesOnly)
      .eigenvalues();
}

ON_RANKS(1, 3);

TEST(Eigensolver, MissesNoModeOfACube) {
  VibratingBody body = cube();
  const Eigen::VectorXd all = all_eigenvalues(body);
  for (int count = 1; count <= 20; ++count) {
    const Modes found = body.find({.count = count}, MPI_COMM_SELF);
    ASSERT_EQ(found.modes.size(), count);
    for (int mode = 0; mode < count; ++mode) {
      const double frequency = std::sqrt(all[rigid + mode]) / (2 * std::numbers::pi);
      ASSERT_NEAR(found.modes[mode].frequency / frequency, 1, 1e-8) << "mode " << mode << " of " << count;
    }
  }
}

TEST(Eigensolver, MissesNoModeOfACubeUpToAFrequency) {
  VibratingBody body = cube();
  const Eigen::VectorXd all = all_eigenvalues(body);
  for (int count = 1; count <= 20; ++count) {
    const double below = all[rigid + count - 1], above = all[rigid + count];
    if (above < 1.001 * below) {
      continue;  // modes of one frequency are not parted
    }
    const double up_to = std::sqrt((below + above) / 2) / (2 * std::numbers::pi);
    const Modes found = body.find({.up_to = up_to}, MPI_COMM_SELF);
    ASSERT_EQ(found.modes.size(), count) << up_to;
    for (int mode = 0; mode < count; ++mode) {
      EXPECT_NEAR(found.modes[mode].frequency / (std::sqrt(all[rigid + mode]) / (2 * std::numbers::pi)), 1.0, 1e-7);
    }
  }
}

TEST(Eigensolver, FindsAModeWithinRoundingOfTheBoundUpToWhichModesAreWanted) {
  VibratingBody body = block(element::hex(2, 2), {0.3, 0.1, 0.1}, {6, 2, 2});
  const double highest = body.find({.count = 3}, MPI_COMM_SELF).modes.back().frequency;
  const double value = std::pow(2 * std::numbers::pi * highest, 2);
  const Operators operators = operators_of(body, MPI_COMM_WORLD);
  const auto rigid_fields = rigid_motions(body.part, operators, MPI_COMM_WORLD);
  for (const double below : {value * (1 - 1e-9), value * (1 + 1e-9)}) {
    const auto pairs = lowest_eigenpairs(operators, rigid_fields, {.count = 3, .below = below}, 0.01 * value);
    ASSERT_EQ(pairs.size(), 3);
    EXPECT_NEAR(pairs.back().value / value, 1, 1e-8);
  }
}

TEST(Eigensolver, StoppedByAWatchItHasTheLowestModes) {
  VibratingBody body = block(element::hex(2, 2), {0.3, 0.1, 0.1}, {6, 2, 2});
  constexpr int wanted = 60;
  const Modes all = body.find({.count = wanted}, MPI_COMM_WORLD);
  std::size_t told = 0;
  const auto stop = [&](std::size_t done, std::size_t expected) {
    EXPECT_EQ(expected, wanted);
    told = told == 0 ? done : told;
    return !parallel::is_root(MPI_COMM_WORLD);  // one rank's wish is enough
  };
  const Modes some = body.find({.count = wanted, .watch = stop}, MPI_COMM_WORLD);
  EXPECT_EQ(some.modes.size(), told);
  EXPECT_LT(some.modes.size(), wanted);
  for (std::size_t mode = 0; mode < some.modes.size(); ++mode) {
    EXPECT_NEAR(some.modes[mode].frequency / all.modes[mode].frequency, 1, 1e-8) << mode;
  }
}

/// Lengths in millimetres that are read as metres: the residuals of vectors of unit mass grow with the body's mass.
TEST(Eigensolver, DoesNotDependOnTheSizeOfTheBody) {
  constexpr double larger = 1e6;
  VibratingBody body = block(element::hex(2, 2), {0.3, 0.1, 0.05}, {6, 2, 2});
  VibratingBody large = block(element::hex(2, 2), {larger * 0.3, larger * 0.1, larger * 0.05}, {6, 2, 2});
  const Modes expected = body.find({.count = 6}, MPI_COMM_SELF);
  const Modes found = large.find({.count = 6}, MPI_COMM_SELF);
  for (std::size_t mode = 0; mode < 6; ++mode) {
    EXPECT_NEAR(larger * found.modes[mode].frequency / expected.modes[mode].frequency, 1, 1e-8) << mode;
  }
}

/// A clamped ruler, whose elements are so thin that K x has no digits left at its lowest frequency.
TEST(Eigensolver, RefusesModesThatRoundingMakesWrong) {
  VibratingBody ruler = block(element::hex(3, 2), {1.0, 0.02, 3e-4}, {50, 1, 1});
  ruler.fix("x0");
  EXPECT_THAT(ruler.refusal({.count = 1}), HasSubstr("a mode is wrong"));
}

/// The search for the lowest mode finds one that rounding makes wrong.
TEST(Eigensolver, SaysThatThereAreNoModesWhereTheLowestIsNotFound) {
  VibratingBody ruler = block(element::hex(3, 2), {1.0, 0.02, 3e-4}, {50, 1, 1});
  ruler.fix("x0");
  EXPECT_THAT(ruler.refusal({.up_to = 1e-3}),
              HasSubstr("has no modes up to 0.001 Hz, and its lowest one was not found: a mode is wrong"));
}

TEST(Eigensolver, SaysTheLowestFrequencyWhereABodyHasNoModesUpToTheWantedOne) {
  VibratingBody body = cube();
  const double lowest = body.find({.count = 1}, MPI_COMM_SELF).modes.front().frequency;
  try {
    (void)body.find({.up_to = 0.9 * lowest}, MPI_COMM_WORLD);
    FAIL() << "there are no modes";
  } catch (const NoModes& error) {
    EXPECT_NEAR(error.lowest.value() / lowest, 1, 1e-8);
    EXPECT_NE(std::string(error.what()).find(fmt::format("its lowest one is at {:.6g} Hz", lowest)), std::string::npos)
        << error.what();
  }
}

TEST(Inertia, CountsTheEigenvaluesBelowABound) {
  VibratingBody bar = block(element::tet10, {0.2, 0.03, 0.02}, {5, 1, 1});  // no two modes alike
  const Eigen::VectorXd all = all_eigenvalues(bar);
  const Operators operators = operators_of(bar, MPI_COMM_WORLD);
  for (const int mode : {rigid, 12, 40}) {
    EXPECT_EQ(eigenvalues_below(operators, (all[mode] + all[mode + 1]) / 2), mode + 1);
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes

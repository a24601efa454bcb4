// PETSc and SLEPc are up while the tests of a module run.

#include <gtest/gtest.h>
#include <slepcsys.h>

namespace {

class PetscEnvironment : public ::testing::Environment {
 public:
  void SetUp() override { ASSERT_EQ(SlepcInitializeNoArguments(), 0); }
  void TearDown() override { ASSERT_EQ(SlepcFinalize(), 0); }
};

[[maybe_unused]] const auto* const environment = ::testing::AddGlobalTestEnvironment(new PetscEnvironment);

}  // namespace

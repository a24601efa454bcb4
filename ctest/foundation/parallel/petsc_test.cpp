#include "idiophone/foundation/parallel/petsc.hpp"

#include <gtest/gtest.h>
#include <petscvec.h>

#include "ranks.hpp"

namespace idiophone::parallel {
namespace {

/// How many owners a vector has.
int references(Vec vector) {
  PetscInt count = 0;
  petsc(PetscObjectGetReference(reinterpret_cast<PetscObject>(vector), &count));
  return count;
}

Handle<Vec> small_vector() {
  Handle<Vec> vector;
  petsc(VecCreateSeq(PETSC_COMM_SELF, 3, vector.out()));
  return vector;
}

ON_RANKS(1);

TEST(PetscHandle, DestroysWhatItOwns) {
  const Handle<Vec> witness = small_vector();
  for (int again = 0; again < 2; ++again) {
    petsc(PetscObjectReference(reinterpret_cast<PetscObject>(static_cast<Vec>(witness))));
    Handle<Vec> second(static_cast<Vec>(witness));
    EXPECT_EQ(references(witness), 2);
    if (again == 1) {
      petsc(VecCreateSeq(PETSC_COMM_SELF, 1, second.out()));  // takes the place of the first
      EXPECT_EQ(references(witness), 1);
    }
  }
  EXPECT_EQ(references(witness), 1);
}

TEST(PetscHandle, DestroysWhenSomethingThrows) {
  const Handle<Vec> witness = small_vector();
  EXPECT_THROW(
      {
        petsc(PetscObjectReference(reinterpret_cast<PetscObject>(static_cast<Vec>(witness))));
        const Handle<Vec> second(static_cast<Vec>(witness));
        petsc(PETSC_ERR_ARG_OUTOFRANGE);
      },
      std::runtime_error);
  EXPECT_EQ(references(witness), 1);
}

TEST(PetscHandle, MovesItsObject) {
  Handle<Vec> first = small_vector();
  auto* const object = static_cast<Vec>(first);
  Handle<Vec> second = std::move(first);
  EXPECT_EQ(static_cast<Vec>(second), object);
  first = small_vector();
  std::swap(first, second);
  EXPECT_EQ(static_cast<Vec>(first), object);
  EXPECT_EQ(references(object), 1);
}

}  // namespace
}  // namespace idiophone::parallel

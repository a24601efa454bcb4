#include "idiophone/foundation/parallel/reproducible_sum.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <random>
#include <vector>

#include "ranks.hpp"

namespace idiophone::parallel {
namespace {

/// Terms of very different sizes.
std::vector<double> make_terms(std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> terms(count);
  std::ranges::generate(terms, [&] { return normal(random) * std::exp2(4.0 * normal(random)); });
  return terms;
}

ON_RANKS(1, 2, 3, 4);

TEST(FixedPoint, CutsEveryValueToTheNearestUnit) {
  for (const double value : {0.0, 1.0, -1.0, 1e-9, -3.7e-12, 123456.789, -1048576.0, 1048575.99999}) {
    EXPECT_NEAR(FixedPoint::from(value).value(), value, 0x1p-71 + std::abs(value) * 0x1p-53) << value;
  }
  EXPECT_EQ(FixedPoint::from(0x1p-30), (FixedPoint{1, 0}));
  EXPECT_EQ(FixedPoint::from(0x1p-70), (FixedPoint{0, 1}));
  EXPECT_EQ(FixedPoint::from(-5.0 * 0x1p-30 - 3.0 * 0x1p-70), (FixedPoint{-5, -3}));
}

TEST(FixedPoint, CarriesToOneRepresentation) {
  FixedPoint number{5, (std::int64_t{3} << 40) + 17};
  number.carry();
  EXPECT_EQ(number, (FixedPoint{8, 17}));
  FixedPoint negative{5, -(std::int64_t{3} << 40) - 17};
  negative.carry();
  EXPECT_EQ(negative, (FixedPoint{2, -17}));
}

TEST(ReproducibleSum, DoesNotDependOnOrderOrParts) {
  auto terms = make_terms(10000);
  ReproducibleSum forward;
  long double expected = 0.0L;
  for (const double term : terms) {
    forward.add(term);
    expected += term;
  }
  EXPECT_NEAR(forward.value(), static_cast<double>(expected), 1e-10);
  std::ranges::shuffle(terms, std::mt19937(3));
  std::array<ReproducibleSum, 3> parts;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    parts[i % 7 % 3].add(terms[i]);
  }
  parts[2].merge(parts[0]);
  parts[2].merge(parts[1]);
  EXPECT_EQ(parts[2].value(), forward.value());
}

TEST(ReproducibleSum, AddsUpOverRanks) {
  const auto terms = make_terms(1000);
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  ReproducibleSum all, mine;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    all.add(terms[i]);
    if (static_cast<int>(i) % ranks == rank) {
      mine.add(terms[i]);
    }
  }
  auto words = mine.words();
  MPI_Allreduce(MPI_IN_PLACE, words.data(), 4, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(ReproducibleSum::from_words(words).value(), all.value());
}

TEST(ReproducibleSum, WordsOfLargeSumsDoNotOverflow) {
  ReproducibleSum sum;
  for (int i = 0; i < 1000; ++i) {
    sum.add(-1e6);
  }
  EXPECT_EQ(sum.value(), -1e9);
  auto words = sum.words();
  for (auto& word : words) {
    word *= 100000;  // ranks
  }
  EXPECT_FALSE(ReproducibleSum::from_words(words).valid());
  EXPECT_EQ(ReproducibleSum::from_words(sum.words()).value(), -1e9);
}

TEST(ReproducibleSum, StaysInvalidOnceATermIsNotANumberOrTooLarge) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1.1e6}) {
    ReproducibleSum sum;
    sum.add(bad);
    sum.add(1.0);
    EXPECT_FALSE(sum.valid());
    EXPECT_TRUE(std::isnan(sum.value()));
    ReproducibleSum other;
    other.merge(sum);
    EXPECT_FALSE(other.valid());
    EXPECT_FALSE(ReproducibleSum::from_words(sum.words()).valid());
  }
  ReproducibleSum sum;
  for (int i = 0; i < 2000; ++i) {
    sum.add(1e6);
  }
  EXPECT_FALSE(sum.valid());
}

}  // namespace
}  // namespace idiophone::parallel

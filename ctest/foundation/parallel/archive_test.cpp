#include "idiophone/foundation/parallel/archive.hpp"

#include <gmock/gmock.h>

#include <array>

#include "memory_archive.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::parallel {
namespace {

using namespace support;

/// A class with one piece of state of each kind.
struct Oscillator {
  explicit Oscillator(const std::vector<std::int32_t>& numbers)
      : rows(numbers, 11, MPI_COMM_WORLD),
        position(numbers.size()),
        velocity(numbers.size()),
        turns(numbers.size(), -1) {}

  void archive(Archive& archive) {
    archive.rows("state", rows, [this](std::size_t i, ArchiveRow& row) {
      row.value(position[i]);
      row.values(velocity[i]);
      row.value(turns[i]);
    });
    archive.rows("nothing", rows, [](std::size_t, ArchiveRow&) {});
    archive.root("time", time);
    archive.root("step", step);
    archive.sum("work", work);
  }

  Rows rows;
  std::vector<double> position;
  std::vector<std::array<float, 2>> velocity;
  std::vector<std::int64_t> turns;
  double time = 0.0;
  std::int64_t step = 0;
  ReproducibleSum work;
};

double total(const ReproducibleSum& share) {
  auto words = share.words();
  MPI_Allreduce(MPI_IN_PLACE, words.data(), static_cast<int>(words.size()), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return ReproducibleSum::from_words(words).value();
}

ON_RANKS(1, 2, 3, 4);

TEST(Archive, RestoresWhatItSavedInAnotherLayout) {
  MemoryArchive archive(MPI_COMM_WORLD);
  Oscillator saved(dealt(11, 0));
  saved.position = values_of(dealt(11, 0), 1);
  for (std::size_t i = 0; i < saved.turns.size(); ++i) {
    const std::int32_t number = dealt(11, 0)[i];
    saved.velocity[i] = {1.0F + static_cast<float>(number), -0.5F};
    saved.turns[i] = number + (std::int64_t{1} << 50);
  }
  saved.time = rank() == 0 ? 0.5 : -1.0;
  saved.step = rank() == 0 ? std::int64_t{1} << 40 : -1;
  saved.work.add(1.0 + rank());
  saved.archive(archive);
  archive.restore();
  Oscillator restored(all_on_last(11));
  restored.archive(archive);
  EXPECT_EQ(restored.position, values_of(all_on_last(11), 1));
  for (std::size_t i = 0; i < restored.turns.size(); ++i) {
    EXPECT_EQ(restored.velocity[i][0], 1.0F + static_cast<float>(i));
    EXPECT_EQ(restored.velocity[i][1], -0.5F);
    EXPECT_EQ(restored.turns[i], static_cast<std::int64_t>(i) + (std::int64_t{1} << 50));
  }
  EXPECT_EQ(restored.time, 0.5);
  EXPECT_EQ(restored.step, std::int64_t{1} << 40);
  EXPECT_EQ(total(restored.work), ranks() + ranks() * (ranks() - 1) / 2.0);
  EXPECT_EQ(total(saved.work), total(restored.work)) << "saving changed the state";
}

TEST(Archive, RefusesAnotherNumberOfValues) {
  MemoryArchive archive(MPI_COMM_WORLD);
  archive.restore();
  archive.integers["step"] = {1, 2};
  std::int64_t step = 0;
  EXPECT_THAT(error_of([&] { archive.root("step", step); }), ::testing::HasSubstr("step holds 2 values"));
}

TEST(ArchiveNames, ListsEachNameOnce) {
  ArchiveNames names(MPI_COMM_WORLD);
  Oscillator oscillator(dealt(11, 0));
  oscillator.archive(names);
  EXPECT_THAT(names.names(), ::testing::ElementsAre("state", "step", "time", "work"));
  EXPECT_THAT(error_of([&] { oscillator.archive(names); }), ::testing::HasSubstr("state is named twice"));
}

}  // namespace
}  // namespace idiophone::parallel

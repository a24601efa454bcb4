#include "idiophone/parallel/archive.hpp"

#include <gmock/gmock.h>

#include <map>

#include "shared_folder.hpp"

namespace idiophone::parallel {
namespace {

using namespace test_support;

/// Keeps blocks of rows and rank 0's values in memory.
class MemoryArchive : public Archive {
 public:
  MemoryArchive() : Archive(MPI_COMM_WORLD) {}
  [[nodiscard]] bool restoring() const override { return restoring_; }
  void restore() { restoring_ = true; }
  std::map<std::string, std::vector<std::int64_t>> integers;

 protected:
  void exchange_rows(const std::string& name, const Rows& rows, int width, std::vector<double>& values) override {
    if (restoring_) {
      values = rows.from_blocks(std::span<const double>(blocks_.at(name)), width);
    } else {
      blocks_[name] = rows.to_blocks(std::span<const double>(values), width);
    }
  }
  void exchange_root(const std::string& name, std::vector<double>& values) override {
    exchange(doubles_, name, values);
  }
  void exchange_root(const std::string& name, std::vector<std::int64_t>& values) override {
    exchange(integers, name, values);
  }

 private:
  template <class Value>
  void exchange(std::map<std::string, std::vector<Value>>& all, const std::string& name, std::vector<Value>& values) {
    if (restoring_) {
      values = all.at(name);
    } else {
      auto& kept = all[name] = values;
      auto count = static_cast<int>(kept.size());
      MPI_Bcast(&count, 1, MPI_INT, 0, communicator());
      kept.resize(count);
      MPI_Bcast(kept.data(), count * static_cast<int>(sizeof(Value)), MPI_BYTE, 0, communicator());
    }
  }

  bool restoring_ = false;
  std::map<std::string, std::vector<double>> blocks_, doubles_;
};

/// A class with one piece of state of each kind.
struct Oscillator {
  explicit Oscillator(const std::vector<std::int32_t>& numbers)
      : rows(numbers, 11, MPI_COMM_WORLD), position(numbers.size()), velocity(numbers.size()) {}

  void archive(Archive& archive) {
    archive.rows("position", rows, 1, position);
    archive.rows(
        "velocity", rows, 1, [&] { return velocity; }, [&](const std::vector<double>& values) { velocity = values; });
    archive.root("time", time);
    archive.root("step", step);
    archive.sum("work", work);
  }

  Rows rows;
  std::vector<double> position, velocity;
  double time = 0.0;
  std::int64_t step = 0;
  ReproducibleSum work;
};

double total(const ReproducibleSum& share) {
  auto words = share.words();
  MPI_Allreduce(MPI_IN_PLACE, words.data(), static_cast<int>(words.size()), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return ReproducibleSum::from_words(words).value();
}

TEST(Archive, RestoresWhatItSavedInAnotherLayout) {
  MemoryArchive archive;
  Oscillator saved(dealt(11, 0));
  saved.position = values_of(dealt(11, 0), 1);
  saved.velocity = saved.position;
  saved.time = rank() == 0 ? 0.5 : -1.0;
  saved.step = rank() == 0 ? std::int64_t{1} << 40 : -1;
  saved.work.add(1.0 + rank());
  saved.archive(archive);
  archive.restore();
  Oscillator restored(all_on_last(11));
  restored.archive(archive);
  EXPECT_EQ(restored.position, values_of(all_on_last(11), 1));
  EXPECT_EQ(restored.velocity, restored.position);
  EXPECT_EQ(restored.time, 0.5);
  EXPECT_EQ(restored.step, std::int64_t{1} << 40);
  EXPECT_EQ(total(restored.work), ranks() + ranks() * (ranks() - 1) / 2.0);
  EXPECT_EQ(total(saved.work), total(restored.work)) << "saving changed the state";
}

TEST(Archive, RefusesAnotherNumberOfValues) {
  MemoryArchive archive;
  archive.restore();
  archive.integers["step"] = {1, 2};
  std::int64_t step = 0;
  EXPECT_THAT(error_of([&] { archive.root("step", step); }), ::testing::HasSubstr("step holds 2 values"));
}

TEST(ArchiveNames, ListsEachNameOnce) {
  ArchiveNames names(MPI_COMM_WORLD);
  Oscillator oscillator(dealt(11, 0));
  oscillator.archive(names);
  EXPECT_THAT(names.names(), ::testing::ElementsAre("position", "step", "time", "velocity", "work"));
  EXPECT_THAT(error_of([&] { oscillator.archive(names); }), ::testing::HasSubstr("position is named twice"));
}

}  // namespace
}  // namespace idiophone::parallel

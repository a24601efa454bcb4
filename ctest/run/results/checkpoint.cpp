#include "idiophone/run/results/checkpoint.hpp"

#include <hdf5.h>

#include <limits>

#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {

using namespace support;
using parallel::Rows;
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::int32_t node_count = 211;
const std::vector<double> filter = {0.1, -0.0, std::numeric_limits<double>::denorm_min()};

/// Writes a checkpoint whose content depends on the step.
std::filesystem::path write_checkpoint(const std::filesystem::path& directory, std::int64_t step, int keep = 3) {
  const auto numbers = dealt(node_count, 1);
  const Rows rows(numbers, node_count, MPI_COMM_WORLD);
  auto velocity = values_of(numbers, 3);
  for (auto& value : velocity) {
    value *= static_cast<double>(step);
  }
  CheckpointWriter writer(directory, identity, {.step = step, .sample = step / 10}, MPI_COMM_WORLD);
  writer.add_rows("motion/velocity", rows, 3, velocity);
  writer.add_root("filter", rank() == 0 ? filter : std::vector<double>());
  writer.add_root("nothing", std::span<const double>());
  writer.add_root("counter", std::vector<std::int64_t>{1LL << 60U, -step});
  return writer.commit(keep);
}

std::vector<std::string> names_in(const std::filesystem::path& directory) {
  barrier();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  barrier();
  return names;
}

ON_RANKS(1, 3);

TEST(Checkpoint, ComesBackToTheBitInAnotherLayout) {
  const Folder folder;
  write_checkpoint(folder.path(), 7);
  const auto [checkpoint, refused, rebuilt] = find_checkpoint(folder.path(), identity, {}, MPI_COMM_WORLD);
  EXPECT_THAT(rebuilt, IsEmpty());
  EXPECT_THAT(refused, IsEmpty());
  ASSERT_TRUE(checkpoint);
  EXPECT_EQ(checkpoint->moment().step, 7);
  EXPECT_EQ(checkpoint->moment().sample, 0);
  EXPECT_EQ(checkpoint->identity().deck_text, identity.deck_text);
  for (const auto& numbers : {dealt(node_count, 0), dealt(node_count, 2), all_on_last(node_count)}) {
    const Rows rows(numbers, node_count, MPI_COMM_WORLD);
    auto expected = values_of(numbers, 3);
    for (auto& value : expected) {
      value *= 7;
    }
    EXPECT_EQ(checkpoint->read_rows("motion/velocity", rows, 3), expected);
  }
  const auto found = checkpoint->read_root("filter");
  EXPECT_EQ(found, filter);
  EXPECT_TRUE(std::signbit(found.at(1)));
  EXPECT_THAT(checkpoint->read_root("nothing"), IsEmpty());
  EXPECT_THAT(checkpoint->read_integer_root("counter"), ElementsAre(1LL << 60U, -7));
}

TEST(Checkpoint, WrongQuestionsAreRefused) {
  const Folder folder;
  write_checkpoint(folder.path(), 7);
  const auto search = find_checkpoint(folder.path(), identity, {}, MPI_COMM_WORLD);
  const auto& checkpoint = search.checkpoint.value();
  const Rows rows(dealt(node_count, 0), node_count, MPI_COMM_WORLD);
  EXPECT_THAT(error_of([&] { return checkpoint.read_rows("motion/speed", rows, 3); }), HasSubstr("motion/speed"));
  EXPECT_THAT(error_of([&] { return checkpoint.read_rows("motion/velocity", rows, 2); }),
              HasSubstr("does not have 211 rows of 2"));
  EXPECT_THAT(error_of([&] { return checkpoint.read_integer_root("filter"); }), HasSubstr("another type"));
}

TEST(Checkpoint, KeepsTheNewest) {
  const Folder folder;
  for (const auto step : {10, 20, 30, 40}) {
    write_checkpoint(folder.path(), step, 2);
  }
  EXPECT_THAT(names_in(folder.path()),
              ElementsAre("checkpoint_000000000030.h5", "checkpoint_000000000040.h5", "latest"));
}

TEST(Checkpoint, ANewRunReplacesTheLaterStepsOfAnOldOne) {
  const Folder folder;
  write_checkpoint(folder.path(), 40);
  write_checkpoint(folder.path(), 10, 1);
  EXPECT_THAT(names_in(folder.path()), ElementsAre("checkpoint_000000000010.h5", "latest"));
}

TEST(Checkpoint, DamageIsFoundAndTheOlderOneIsTaken) {
  const Folder folder;
  const auto truncate = [](const auto& path) { std::filesystem::resize_file(path, 3000); };
  const auto remove_marker = [](const auto& path) {
    const auto file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Adelete(file, "end_marker");
    H5Fclose(file);
  };
  const auto change_step = [](const auto& path) {
    const auto file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const auto attribute = H5Aopen(file, "step", H5P_DEFAULT);
    const std::int64_t step = 21;
    H5Awrite(attribute, H5T_NATIVE_INT64, &step);
    H5Aclose(attribute);
    H5Fclose(file);
  };
  const auto flip_value = [](const auto& path) {
    const auto byte = static_cast<std::streamoff>(place_of(bytes_of(path), value_of(18, 1) * 20));
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(byte);
    file.put('!');
  };
  const auto expect_refusal = [&](const auto& damage, const std::string& reason) {
    write_checkpoint(folder.path(), 10);
    const auto path = write_checkpoint(folder.path(), 20);
    if (rank() == 0) {
      damage(path);
    }
    barrier();
    const auto [checkpoint, refused, rebuilt] = find_checkpoint(folder.path(), identity, {}, MPI_COMM_WORLD);
    EXPECT_THAT(rebuilt, IsEmpty());
    ASSERT_EQ(refused.size(), 1U) << reason;
    EXPECT_EQ(refused[0].path, path);
    EXPECT_THAT(refused[0].reason, HasSubstr(reason));
    ASSERT_TRUE(checkpoint);
    EXPECT_EQ(checkpoint->moment().step, 10);
  };
  expect_refusal(truncate, "damaged");
  expect_refusal(remove_marker, "no end marker");
  expect_refusal(change_step, "end marker does not match");
  expect_refusal(flip_value, "bad checksum of /state/motion/velocity");
  expect_refusal([](const auto& path) { std::ofstream(path, std::ios::binary) << ""; }, "damaged");
  expect_refusal([](const auto& path) { std::filesystem::remove(path); }, "No such file");
}

TEST(Checkpoint, OtherRunsAreRefused) {
  const Folder folder;
  write_checkpoint(folder.path(), 10);
  const auto reason_for = [&](const Identity& other) {
    const auto search = find_checkpoint(folder.path(), other, {}, MPI_COMM_WORLD);
    EXPECT_FALSE(search.checkpoint);
    return search.refused.empty() ? "" : search.refused[0].reason;
  };
  auto other = identity;
  other.code_version = "0.2.0";
  EXPECT_THAT(reason_for(other), HasSubstr("other code version: 0.1.0 wrote it, this is 0.2.0"));
  other = identity;
  other.mesh_hash = "f";
  EXPECT_THAT(reason_for(other), HasSubstr("other mesh"));
  other = identity;
  other.deck_text += "#";
  EXPECT_THAT(reason_for(other), HasSubstr("other deck"));
  other = identity;
  other.overrides = {};
  EXPECT_THAT(reason_for(other), HasSubstr("other overrides: it was written by a run with --set '"));
  EXPECT_THAT(reason_for(other), HasSubstr("', this one has no --set"));
}

TEST(Checkpoint, TheOthersAreTriedWhenLatestPointsNowhere) {
  const Folder folder;
  write_checkpoint(folder.path(), 10);
  write_checkpoint(folder.path(), 20);
  for (const auto* const pointer : {"", "../secret\n", "\xff\xff"}) {
    if (rank() == 0) {
      std::ofstream(folder / "latest") << pointer;
    }
    barrier();
    const auto [checkpoint, refused, rebuilt] = find_checkpoint(folder.path(), identity, {}, MPI_COMM_WORLD);
    EXPECT_THAT(rebuilt, IsEmpty());
    ASSERT_TRUE(checkpoint);
    EXPECT_EQ(checkpoint->moment().step, 20);
    barrier();
  }
}

TEST(Checkpoint, InterruptedWritingsAreRemovedAtTheNext) {
  const Folder folder;
  if (rank() == 0) {
    std::ofstream(folder / "checkpoint_000000000005.h5.part") << "half";
    std::ofstream(folder / "notes.part") << "not ours";
  }
  barrier();
  write_checkpoint(folder.path(), 10);
  EXPECT_THAT(names_in(folder.path()), ElementsAre("checkpoint_000000000010.h5", "latest", "notes.part"));
}

TEST(Checkpoint, OneNotCommittedLeavesNothing) {
  const Folder folder;
  { const CheckpointWriter writer(folder.path(), identity, {}, MPI_COMM_WORLD); }
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(Checkpoint, FailureToWriteLeavesTheEarlierOnes) {
  const Folder folder;
  write_checkpoint(folder.path(), 10);
  const Rows rows(dealt(node_count, 0), node_count, MPI_COMM_WORLD);
  CheckpointWriter writer(folder.path(), identity, {.step = 20, .sample = 2}, MPI_COMM_WORLD);
  EXPECT_THAT(error_of([&] { writer.add_rows("u", rows, 3, std::vector<double>(1)); }), HasSubstr("bytes given"));
  writer.add_rows("u", rows, 3, values_of(dealt(node_count, 0), 3));
  EXPECT_THAT(error_of([&] { writer.add_rows("u", rows, 3, values_of(dealt(node_count, 0), 3)); }),
              HasSubstr("/state/u"));
  EXPECT_EQ(find_checkpoint(folder.path(), identity, {}, MPI_COMM_WORLD).checkpoint.value().moment().step, 10);
}

TEST(Checkpoint, ADirectoryThatCannotBeMadeIsAnError) {
  const Folder folder;
  if (rank() == 0) {
    std::ofstream(folder / "file") << "";
  }
  barrier();
  EXPECT_THAT(error_of([&] { CheckpointWriter(folder / "file" / "in", identity, {}, MPI_COMM_WORLD); }),
              HasSubstr("Not a directory"));
  EXPECT_THAT(find_checkpoint(folder / "none", identity, {}, MPI_COMM_WORLD).refused, IsEmpty());
}

}  // namespace
}  // namespace idiophone::results

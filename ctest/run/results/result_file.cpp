#include "idiophone/run/results/result_file.hpp"

#include <fmt/format.h>

#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

ON_RANKS(1, 3);

TEST(ResultFile, WhatIsAppendedInBlocksComesBackWhole) {
  const Folder folder;
  auto result = ResultFile::create(folder / "plate.h5", origin, MPI_COMM_WORLD);
  result.declare(ears);
  for (const auto& [begin, end] : {std::pair(0, 3), std::pair(3, 3), std::pair(3, 6000)}) {
    result.append(ears.path, rank() == 0 ? audio(begin, end) : std::vector<double>());
    result.flush();
  }
  const auto sounds = read_sounds(folder / "plate.h5");
  ASSERT_THAT(sounds, SizeIs(1));
  EXPECT_EQ(sounds[0].name, "ears");
  EXPECT_EQ(sounds[0].rate, 44100.0);
  EXPECT_EQ(sounds[0].unit, "Pa m");
  EXPECT_THAT(sounds[0].channels, ElementsAre("ears.left", "ears.right"));
  ASSERT_THAT(sounds[0].samples, SizeIs(2));
  ASSERT_THAT(sounds[0].samples[1], SizeIs(6000));
  EXPECT_EQ(sounds[0].samples[0][4321], value_of(4321, 0));
  EXPECT_EQ(sounds[0].samples[1][4321], value_of(4321, 1));
}

// HDF5 exchanges changed metadata when enough of it has changed. All ranks must take part. Rank 0 waited forever while
// it wrote the rows of 64 bodies in contact.
TEST(ResultFile, ABlockTakesRowsOfManySeries) {
  const Folder folder;
  auto result = ResultFile::create(folder / "contacts.h5", origin, MPI_COMM_WORLD);
  std::vector<spectra::Series> series;
  for (int contact = 0; contact < 250; ++contact) {
    for (const auto& [name, columns] :
         {std::pair("overlap", 1), {"force", 3}, {"point", 3}, {"normal", 3}, {"slip", 3}}) {
      series.push_back(energy);
      series.back().path = fmt::format("/contacts/cube_{:03}_floor/{}", contact, name);
      series.back().columns.resize(columns, "z");
      result.declare(series.back());
    }
  }
  result.flush();
  for (int block = 0; block < 2; ++block) {
    for (const spectra::Series& one : series) {
      result.append(one.path, std::vector<double>(rank() == 0 ? 88 * one.columns.size() : 0, 1.0));
    }
    result.flush();
  }
  EXPECT_EQ(result.lengths().at(series.back().path), 176);
}

TEST(ResultFile, AKilledRunLeavesWhatWasFlushed) {
  const Folder folder;
  auto result = make_result(folder / "plate.h5", 0);
  barrier();
  if (rank() == 0) {
    std::filesystem::copy_file(folder / "plate.h5", folder / "flushed.h5");
  }
  barrier();
  result.append(ears.path, rank() == 0 ? audio(100, 9000) : std::vector<double>());
  barrier();
  if (rank() == 0) {  // what a kill would leave now: all but what only lies in memory
    std::filesystem::copy_file(folder / "plate.h5", folder / "killed.h5");
  }
  barrier();
  for (const auto* const name : {"flushed.h5", "killed.h5"}) {
    EXPECT_THAT(read_sounds(folder / name).at(0).samples.at(0), SizeIs(100)) << name;
  }
  auto resumed = ResultFile::open(folder / "killed.h5", MPI_COMM_WORLD);
  resumed.append(ears.path, rank() == 0 ? audio(100, 200) : std::vector<double>());
  resumed.flush();
  EXPECT_EQ(read_sounds(folder / "killed.h5").at(0).samples.at(1).at(150), value_of(150, 1));
}

TEST(ResultFile, ContentsDoNotDependOnTheLayout) {
  const Folder folder;
  make_result(folder / "a.h5", 0).flush();
  make_result(folder / "b.h5", 1).flush();
  EXPECT_EQ(digest(folder / "a.h5"), digest(folder / "b.h5"));
  EXPECT_EQ(digest(folder / "a.h5"), 1833237365U) << "on any number of ranks";
}

TEST(ResultFile, CutBackAndContinuedEqualsTheStraightRun) {
  const Folder folder;
  make_result(folder / "straight.h5", 0).flush();
  files::Lengths lengths;
  {
    auto result = make_result(folder / "cut.h5", 1);
    lengths = result.lengths();
    EXPECT_THAT(lengths, ElementsAre(std::pair("/audio/ears", 100), std::pair("/energy", 4),
                                     std::pair("/frames/hammer/displacement", 3),
                                     std::pair("/frames/plate/displacement", 3), std::pair("/frames/time", 3)));
    add_frame(result, 3, 1);
    result.append(ears.path, rank() == 0 ? audio(100, 7777) : std::vector<double>());
    result.flush();
  }
  auto result = ResultFile::open(folder / "cut.h5", MPI_COMM_WORLD);
  result.truncate(lengths);
  EXPECT_EQ(result.lengths(), lengths);
  result.flush();
  EXPECT_EQ(digest(folder / "cut.h5"), digest(folder / "straight.h5"));

  auto longer = lengths;
  longer["/energy"] = 5;
  EXPECT_THAT(error_of([&] { result.truncate(longer); }), HasSubstr("/energy has 4 rows, and had 5"));
  auto other = lengths;
  other["/audio/mouth"] = 1;
  EXPECT_THAT(error_of([&] { result.truncate(other); }), HasSubstr("has no /audio/mouth"));
  other = lengths;
  other.erase("/energy");
  EXPECT_THAT(error_of([&] { result.truncate(other); }), HasSubstr("/energy has 4 rows, and had none"));
  EXPECT_EQ(result.lengths(), lengths);
}

TEST(ResultFile, ANewRunOverwrites) {
  const Folder folder;
  make_result(folder / "plate.h5", 0).flush();
  auto result = ResultFile::create(folder / "plate.h5", origin, MPI_COMM_WORLD);
  EXPECT_THAT(result.lengths(), ElementsAre(std::pair("/frames/time", 0)));
  EXPECT_THAT(read_sounds(folder / "plate.h5"), IsEmpty());
}

TEST(ResultFile, MistakesAreErrorsOnAllRanks) {
  const Folder folder;
  const auto create = [&](const std::filesystem::path& path) {
    return ResultFile::create(path, origin, MPI_COMM_WORLD);
  };
  EXPECT_THAT(error_of([&] { create(folder / "none" / "plate.h5"); }), HasSubstr("No such file or directory"));
  EXPECT_THAT(error_of([&] { create(folder.path()); }), HasSubstr("Is a directory"));

  auto result = make_result(folder / "plate.h5", 0);
  EXPECT_THAT(error_of([&] { result.declare(ears); }), HasSubstr("/audio/ears"));
  EXPECT_THAT(error_of([&] { result.append("/audio/mouth", {}); }), HasSubstr("/audio/mouth"));
  EXPECT_THAT(error_of([&] { result.append(ears.path, std::vector<double>(3)); }), HasSubstr("it takes rows of 2"));
  EXPECT_THAT(error_of([&] { result.append("/mesh/plate/nodes", std::vector<double>(3)); }), HasSubstr("can't append"));
  EXPECT_THAT(error_of([&] { result.add_frame(1.0, {}); }), HasSubstr("lacks /frames/hammer/displacement"));
  auto series = ears;
  series.path = "energy";
  EXPECT_THAT(error_of([&] { result.declare(series); }), HasSubstr("the path must begin"));
  series = ears;
  series.rate = 0;
  EXPECT_THAT(error_of([&] { result.declare(series); }), HasSubstr("above 0 Hz"));
  series = ears;
  series.positions.pop_back();
  EXPECT_THAT(error_of([&] { result.declare(series); }), HasSubstr("1 positions for 2 columns"));
}

TEST(ResultFile, OnlyAResultCanBeResumed) {
  const Folder folder;
  const auto open = [&](const std::string& name) { return ResultFile::open(folder / name, MPI_COMM_WORLD); };
  EXPECT_THAT(error_of([&] { open("none.h5"); }), HasSubstr("No such file or directory"));
  if (rank() == 0) {
    std::ofstream(folder / "text.h5") << "name: plate\n";
  }
  barrier();
  EXPECT_THAT(error_of([&] { open("text.h5"); }), HasSubstr("can't open"));
  make_result(folder / "cut_off.h5", 0).flush();
  barrier();
  if (rank() == 0) {
    std::filesystem::resize_file(folder / "cut_off.h5", 5000);
  }
  barrier();
  EXPECT_THAT(error_of([&] { open("cut_off.h5"); }), HasSubstr("truncated"));
}

}  // namespace
}  // namespace idiophone::results

#include "idiophone/run/results/sound_reader.hpp"

#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

ON_RANKS(1, 3);

TEST(SoundReader, ReadsSoundsAndReferences) {
  const Folder folder;
  make_result(folder / "plate.h5", 0);
  const auto sounds = read_sounds(folder / "plate.h5");
  ASSERT_THAT(sounds, SizeIs(1));
  EXPECT_EQ(sounds[0].rate, 44100.0);
  EXPECT_EQ(sounds[0].samples.at(1).at(99), value_of(99, 1));
  const auto references = read_references(folder / "plate.h5");
  ASSERT_THAT(references, SizeIs(1));
  EXPECT_EQ(references[0].name, "thin plate (Leissa) 1/2");
  EXPECT_THAT(references[0].frequencies, ElementsAre(161.2, 329.0));
}

TEST(SoundReader, RefusesWhatIsNotAResult) {
  const Folder folder;
  if (rank() == 0) {
    H5Fclose(H5Fcreate((folder / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  }
  barrier();
  EXPECT_THAT(error_of([&] { return read_sounds(folder / "none.h5"); }), HasSubstr("No such file or directory"));
  EXPECT_THAT(error_of([&] { return read_sounds(folder / "other.h5"); }), HasSubstr("another program's file"));
  EXPECT_THAT(error_of([&] { return read_references(folder.path()); }), HasSubstr(folder.path().string()));
}

}  // namespace
}  // namespace idiophone::results

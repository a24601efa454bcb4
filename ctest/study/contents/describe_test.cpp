#include "idiophone/study/contents/describe.hpp"
#include "idiophone/air/harmonic/radiation_file.hpp"

#include "idiophone/run/results/checkpoint.hpp"
#include "ranks.hpp"
#include "results.hpp"
#include "small_radiation.hpp"

namespace idiophone::contents {

using namespace results;  // the files of its tests
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

ON_RANKS(1);

TEST(Describe, TellsWhatIsInAResult) {
  const Folder folder;
  make_result(folder / "plate.h5", 0);
  EXPECT_THAT(describe(folder / "plate.h5"),
              AllOf(HasSubstr("result of the run 'plate & hammer', written by idiophone 0.1.0"),
                    ContainsRegex("/audio/ears +.100 x 2. Pa m, 44100 Hz, 0.00226757 s, loudest 0.666667: ears.left"),
                    ContainsRegex("/frames/plate/displacement +.3 x 70 x 3. m"),
                    ContainsRegex("/references/000 +.2. thin plate")));
}

TEST(Describe, TellsWhetherACheckpointIsValid) {
  const Folder folder;
  results::CheckpointWriter writer(folder.path(), {"0.1.0", "abc", "deck", {}}, {.step = 42, .sample = 7},
                                   MPI_COMM_WORLD);
  writer.add_root("u", std::vector<double>(500, 1.5));
  const auto path = writer.commit(1);
  EXPECT_THAT(describe(path), AllOf(HasSubstr("checkpoint at step 42, sample 7"), HasSubstr("valid: all checksums")));
  barrier();
  if (rank() == 0) {
    const auto file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Adelete(file, "end_marker");
    H5Fclose(file);
  }
  barrier();
  EXPECT_THAT(describe(path), HasSubstr("NOT VALID: no end marker"));
}

TEST(Describe, TellsWhatABodyRadiates) {
  const Folder folder;
  const auto path = folder / "plate_radiation.h5";
  if (rank() == 0) {
    harmonic::write_radiation(path, {"drum", "0.2.0", "deck", {}}, harmonic::small_radiation());
  }
  barrier();
  EXPECT_THAT(describe(path),
              AllOf(HasSubstr("sound that the body 'plate' of the deck 'drum' radiates"),
                    HasSubstr("2 sounds from 200 to 450.5 Hz; 3 vertices, 2 triangles of plate, screen"),
                    ContainsRegex("/sounds/power +.2. W")));
}

TEST(Describe, RefusesOtherFiles) {
  const Folder folder;
  if (rank() == 0) {
    H5Fclose(H5Fcreate((folder / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    std::ofstream(folder / "text") << "text";
  }
  barrier();
  EXPECT_THAT(error_of([&] { return describe(folder / "other.h5"); }),
              HasSubstr("no result, recording, checkpoint, sound map, radiated sound or mesh"));
  EXPECT_THAT(error_of([&] { return describe(folder / "text"); }), HasSubstr("is not an HDF5 file, or is damaged"));
}

}  // namespace
}  // namespace idiophone::contents

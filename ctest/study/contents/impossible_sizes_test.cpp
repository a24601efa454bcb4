// Files whose checksums are right or missing, and whose sizes make no sense: readers refuse them by name, and allocate
// nothing for them.

#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "ranks.hpp"
#include "results.hpp"
#include "small_map.hpp"
#include "xdmf.hpp"

namespace idiophone::contents {

using namespace results;  // the files of its tests
using namespace sound_maps;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A result that rank 0 changes.
class ImpossibleSizes : public testing::Test {
 protected:
  ImpossibleSizes() { static_cast<void>(make_result(path_, 0)); }

  /// Puts a dataset of which nothing is stored in the place of another.
  void replace(const std::string& name, hid_t type, const std::vector<hsize_t>& shape) const {
    change([&](hid_t file) {
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
      const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
      const std::vector<hsize_t> chunk(shape.size(), 1);
      H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data());
      H5Dclose(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT));
      H5Pclose(list);
      H5Sclose(space);
    });
  }

  template <class Change>
  void change(const Change& action) const {
    barrier();
    if (rank() == 0) {
      const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
      action(file);
      H5Fclose(file);
    }
    barrier();
  }

  const Folder folder_;
  const std::filesystem::path path_ = folder_ / "plate.h5";
};

ON_RANKS(1);

TEST_F(ImpossibleSizes, OfATableAreNotAllocated) {
  replace("/references/000", H5T_NATIVE_DOUBLE, {hsize_t{1} << 40U});
  EXPECT_THAT(error_of([&] { results::require_intact(path_); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("/references/000 has 8.8e+12 bytes, but only 0 are in the file")));
}

TEST_F(ImpossibleSizes, OfAnAttributeAreNotAllocated) {
  change([](hid_t file) {
    H5Adelete(file, "code_version");
    const std::array<hsize_t, 1> shape = {hsize_t{1} << 40U};
    const hid_t space = H5Screate_simple(1, shape.data(), nullptr);
    const hid_t attribute = H5Acreate2(file, "code_version", H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute >= 0) {
      H5Aclose(attribute);
    }
    H5Sclose(space);
  });
  EXPECT_THAT(error_of([&] { static_cast<void>(contents::describe(path_)); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("code_version")));
}

TEST_F(ImpossibleSizes, OfAMeshAreRefused) {
  replace("/mesh/hammer/elements", H5T_NATIVE_INT32, {8});
  EXPECT_THAT(error_of([&] { const results::FrameReader reader(path_); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("body hammer has no nodes or no cells")));
}

TEST_F(ImpossibleSizes, PicturesAreNotDescribed) {
  replace("/mesh/hammer/nodes", H5T_NATIVE_DOUBLE, {});
  EXPECT_THAT(error_of([&] { (void)results::write_xdmf(path_); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("/mesh/hammer/nodes is no table")));
  replace("/mesh/hammer/nodes", H5T_NATIVE_DOUBLE, {4, 3});
  replace("/mesh/hammer/elements", H5T_NATIVE_INT32, {2, 5});
  EXPECT_THAT(error_of([&] { (void)results::write_xdmf(path_); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("cells of 5 nodes")));
}

TEST_F(ImpossibleSizes, ASeriesWithoutARateIsRefused) {
  change([](hid_t file) {
    const hid_t table = H5Dopen2(file, "/energy", H5P_DEFAULT);
    const hid_t attribute = H5Aopen(table, "rate", H5P_DEFAULT);
    const double none = 0.0;
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &none);
    H5Aclose(attribute);
    H5Dclose(table);
  });
  EXPECT_THAT(error_of([&] { const results::SeriesReader reader(path_); }),
              AllOf(HasSubstr("plate.h5"), HasSubstr("/energy has a rate of 0 Hz")));
}

TEST_F(ImpossibleSizes, ADatasetWithoutChecksumIsNotResumed) {
  EXPECT_EQ(error_of([&] { results::require_as_saved(path_, {}); }), "");
  change([](hid_t file) {
    const hid_t nodes = H5Dopen2(file, "/mesh/plate/nodes", H5P_DEFAULT);
    H5Adelete(nodes, "crc32");
    H5Dclose(nodes);
  });
  EXPECT_THAT(error_of([&] { results::require_as_saved(path_, {}); }),
              AllOf(HasSubstr("/mesh/plate/nodes"), HasSubstr("no checksum")));
}

TEST_F(ImpossibleSizes, ATableThatIsGoneIsNotResumed) {
  EXPECT_THAT(error_of([&] {
                results::require_as_saved(path_, {{"/frames/time", {.rows = 3, .digest = 0}}});
              }),
              HasSubstr("/frames/time"));
  change([](hid_t file) { H5Ldelete(file, "/frames/time", H5P_DEFAULT); });
  EXPECT_THAT(error_of([&] {
                results::require_as_saved(path_, {{"/frames/time", {.rows = 3, .digest = 0}}});
              }),
              HasSubstr("/frames/time: it is missing"));
}

TEST_F(ImpossibleSizes, ASoundMapNeedsOneDeckAndOneCentre) {
  const auto refusal = [&](const std::function<void(hid_t)>& action) {
    barrier();
    if (rank() == 0) {
      sound_maps::write_sound_map(path_, small_map());
    }
    change(action);
    auto said = error_of([&] { static_cast<void>(sound_maps::read_sound_map(path_)); });
    barrier();
    return said;
  };
  EXPECT_THAT(refusal([](hid_t file) {
                H5Adelete(file, "centre");
                const std::array<hsize_t, 2> shape = {0, 3};
                const hid_t space = H5Screate_simple(2, shape.data(), nullptr);
                H5Aclose(H5Acreate2(file, "centre", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT));
                H5Sclose(space);
              }),
              HasSubstr("centre is not one point"));
  EXPECT_THAT(refusal([](hid_t file) {
                H5Ldelete(file, "/deck", H5P_DEFAULT);
                const std::array<hsize_t, 1> shape = {0};
                const hid_t space = H5Screate_simple(1, shape.data(), nullptr);
                H5Dclose(H5Dcreate2(file, "/deck", H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
                H5Sclose(space);
              }),
              HasSubstr("dataset /deck is not one text"));
}

}  // namespace
}  // namespace idiophone::contents

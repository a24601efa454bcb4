#include "idiophone/run/results/series_reader.hpp"

#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> paths_of(const SeriesReader& reader) {
  std::vector<std::string> paths;
  for (const spectra::Series& series : reader.all()) {
    paths.push_back(series.path);
  }
  return paths;
}

class SeriesReaderTest : public ::testing::Test {
 protected:
  SeriesReaderTest() { make_result(folder_ / "plate.h5", 0); }

  Folder folder_;
};

ON_RANKS(1, 3);

TEST_F(SeriesReaderTest, ListsEverySeriesWithTheDescriptionItWasDeclaredWith) {
  const SeriesReader reader(folder_ / "plate.h5");
  EXPECT_THAT(paths_of(reader), ElementsAre("/audio/ears", "/energy"));  // no meshes, frames or references
  const spectra::Series& found = reader.find("/audio/ears");
  EXPECT_EQ(found.path, ears.path);
  EXPECT_EQ(found.unit, ears.unit);
  EXPECT_EQ(found.rate, ears.rate);
  EXPECT_EQ(found.columns, ears.columns);
  EXPECT_EQ(found.description, ears.description);
  EXPECT_EQ(found.positions, ears.positions);
  EXPECT_TRUE(reader.find("/energy").positions.empty());
}

TEST_F(SeriesReaderTest, ReadsRowsByName) {
  const SeriesReader reader(folder_ / "plate.h5");
  EXPECT_EQ(reader.read(reader.find("energy")), std::vector<double>(12, 0.5));
  const spectra::Series& sound = reader.find("audio/ears");
  EXPECT_EQ(reader.rows(sound), 100);
  EXPECT_EQ(reader.read(sound), audio(0, 100));
  EXPECT_EQ(reader.read(sound, 30, 5), audio(30, 35));
  EXPECT_THAT(error_of([&] { return reader.read(sound, 96, 5); }),
              HasSubstr("/audio/ears has 100 rows, not 5 from 96"));
}

TEST_F(SeriesReaderTest, NamesTheNearestSeriesWhenThereIsNoneOfThatName) {
  const SeriesReader reader(folder_ / "plate.h5");
  EXPECT_EQ(error_of([&] { return reader.find("energie").path; }),
            "there is no channel /energie (did you mean '/energy'?)");
  EXPECT_EQ(error_of([&] { return reader.find("/contacts/hit/force").path; }),
            "there is no channel /contacts/hit/force");
}

TEST_F(SeriesReaderTest, RefusesWhatIsNotAResultOrContradictsItself) {
  EXPECT_THAT(error_of([&] { return SeriesReader(folder_ / "none.h5").all(); }), HasSubstr("No such file"));
  barrier();
  if (rank() == 0) {
    const hid_t file = H5Fopen((folder_ / "plate.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "/audio/ears", H5P_DEFAULT);
    const hid_t attribute = H5Aopen(dataset, "columns", H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    H5Aclose(attribute);
    H5Adelete(dataset, "columns");
    const hsize_t count = 1;
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const std::vector<char> text(H5Tget_size(type), 'a');
    const hid_t single = H5Acreate2(dataset, "columns", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(single, type, text.data());
    H5Aclose(single);
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(dataset);
    H5Fclose(file);
  }
  barrier();
  EXPECT_THAT(error_of([&] { return SeriesReader(folder_ / "plate.h5").all(); }),
              HasSubstr("/audio/ears has names for 1 columns, but another shape"));
}

}  // namespace
}  // namespace idiophone::results

// Recordings of surface motion: what is written in blocks, on any number of ranks, comes back to the bit.

#include <hdf5.h>

#include <functional>

#include "idiophone/run/results/surface_motion_file.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr std::int32_t triangle_count = 11;
constexpr std::int32_t vertex_count = 8;

const surface::RecordingHeader header{.origin = origin,
                                      .rate = 8000,
                                      .first_sample = -6,
                                      .samples = 100,
                                      .air_density = 1.2,
                                      .air_speed = 340,
                                      .bodies = {{"plate", 0, 0}, {"hammer", 7, 5}},
                                      .obstacle_triangles = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                      .half_spaces = {0, 0, -1, 0, 0, 1}};

double pressure_of(std::int64_t row, std::int32_t triangle) {
  return value_of(static_cast<std::int32_t>(row), triangle);
}

double position_of(std::int64_t row, std::int32_t vertex, int axis) {
  return -value_of(static_cast<std::int32_t>(row), 3 * vertex + axis);
}

/// A surface whose triangles and vertices are dealt to the ranks, and its recording.
class Recorded {
 public:
  explicit Recorded(int first)
      : triangles_(dealt(triangle_count, first)),
        vertices_(dealt(vertex_count, first)),
        triangle_rows_(triangles_, triangle_count, MPI_COMM_WORLD),
        vertex_rows_(vertices_, vertex_count, MPI_COMM_WORLD) {
    for (const auto triangle : triangles_) {
      corners_.insert(corners_.end(), {triangle % vertex_count, (triangle + 1) % vertex_count, 7});
    }
    for (const auto vertex : vertices_) {
      reference_.insert(reference_.end(), {1.0 * vertex, 2.0, 3.0});
    }
  }

  [[nodiscard]] surface::RecordedSurface surface() const {
    return {&triangle_rows_, &vertex_rows_, corners_, reference_};
  }

  void append(SurfaceMotionFile& file, std::int64_t begin, std::int64_t end) const {
    std::vector<double> pressure, position;
    for (auto row = begin; row < end; ++row) {
      for (const auto triangle : triangles_) {
        pressure.push_back(pressure_of(row, triangle));
      }
      for (const auto vertex : vertices_) {
        for (int axis = 0; axis < 3; ++axis) {
          position.push_back(position_of(row, vertex, axis));
        }
      }
    }
    file.append(end - begin, pressure, position);
    file.flush();
  }

  void make(const std::filesystem::path& path, const std::vector<std::int64_t>& ends) const {
    auto file = SurfaceMotionFile::create(path, header, surface(), MPI_COMM_WORLD);
    std::int64_t begin = 0;
    for (const auto end : ends) {
      append(file, std::exchange(begin, end), end);
    }
  }

 private:
  std::vector<std::int32_t> triangles_, vertices_;
  Rows triangle_rows_, vertex_rows_;
  std::vector<std::int32_t> corners_;
  std::vector<double> reference_;
};

void expect_rows(const std::filesystem::path& path, std::int64_t rows) {
  const SurfaceMotionReader reader(path);
  ASSERT_EQ(reader.rows(), rows);
  const auto pressure = reader.read_pressure(1, rows - 1, 2, 4);
  const auto position = reader.read_position(1, rows - 1, 3, 2);
  for (std::int64_t row = 1; row < rows; ++row) {
    for (int i = 0; i < 4; ++i) {
      ASSERT_EQ(pressure[static_cast<std::size_t>(4 * (row - 1) + i)], pressure_of(row, 2 + i));
    }
    for (int i = 0; i < 6; ++i) {
      ASSERT_EQ(position[static_cast<std::size_t>(6 * (row - 1) + i)], position_of(row, 3 + i / 3, i % 3));
    }
  }
}

ON_RANKS(1, 3);

TEST(SurfaceMotion, BlocksFromAllRanksComeBackWhole) {
  const Folder folder;
  Recorded(0).make(folder / "plate_surface.h5", {1, 1, 4, 300});
  expect_rows(folder / "plate_surface.h5", 300);
  const SurfaceMotionReader reader(folder / "plate_surface.h5");
  EXPECT_EQ(reader.triangles(), triangle_count);
  EXPECT_EQ(reader.vertices(), vertex_count);
  EXPECT_EQ(reader.header().first_sample, -6);
  EXPECT_EQ(reader.header().samples, 100);
  EXPECT_EQ(reader.header().air_speed, 340);
  EXPECT_EQ(reader.header().origin.deck_text, origin.deck_text);
  EXPECT_EQ(reader.header().origin.overrides, origin.overrides);
  ASSERT_THAT(reader.header().bodies, SizeIs(2));
  EXPECT_EQ(reader.header().bodies[1].name, "hammer");
  EXPECT_EQ(reader.header().bodies[1].first_vertex, 5);
  EXPECT_EQ(reader.header().obstacle_triangles, header.obstacle_triangles);
  EXPECT_EQ(reader.header().half_spaces, header.half_spaces);
  EXPECT_THAT(reader.read_triangles(2, 1), ElementsAre(ElementsAre(2, 3, 7)));
  EXPECT_THAT(reader.read_reference(4, 1), ElementsAre(4, 2, 3));
}

TEST(SurfaceMotion, ContentsDoNotDependOnTheLayout) {
  const Folder folder;
  Recorded(0).make(folder / "a.h5", {1, 50});
  Recorded(1).make(folder / "b.h5", {20, 50});
  EXPECT_EQ(digest(folder / "a.h5"), digest(folder / "b.h5"));
}

TEST(SurfaceMotion, AResumedRunCutsAndGoesOn) {
  const Folder folder;
  {
    const Recorded first(0);
    auto file = SurfaceMotionFile::create(folder / "plate_surface.h5", header, first.surface(), MPI_COMM_WORLD);
    first.append(file, 0, 33);
    save(folder.path(), 33, [&](auto& archive) { file.archive(archive); });
    first.append(file, 33, 90);
  }
  const Recorded other(1);
  auto file = SurfaceMotionFile::open(folder / "plate_surface.h5", other.surface(), MPI_COMM_WORLD);
  restore(folder.path(), [&](auto& archive) { file.archive(archive); });
  expect_rows(folder / "plate_surface.h5", 33);
  other.append(file, 33, 120);
  expect_rows(folder / "plate_surface.h5", 120);
  barrier();
  Recorded(0).make(folder / "whole.h5", {120});
  EXPECT_EQ(digest(folder / "plate_surface.h5"), digest(folder / "whole.h5"));
}

TEST(SurfaceMotion, WhatCanNotGoOnIsAnError) {
  const Folder folder;
  const Recorded recorded(0);
  recorded.make(folder / "plate_surface.h5", {20});
  const auto open = [&](const std::string& name, const surface::RecordedSurface& surface) {
    return error_of([&] { (void)SurfaceMotionFile::open(folder / name, surface, MPI_COMM_WORLD); });
  };
  EXPECT_THAT(open("none.h5", recorded.surface()), HasSubstr("No such file"));
  make_result(folder / "plate.h5", 0);
  EXPECT_THAT(open("plate.h5", recorded.surface()),
              HasSubstr("is not an idiophone surface motion but an idiophone result"));
  const std::vector<std::int32_t> one = {0};
  const Rows single(one, 1, MPI_COMM_WORLD);
  const surface::RecordedSurface smaller{&single, &single, one, {}};
  EXPECT_THAT(open("plate_surface.h5", smaller), HasSubstr("another surface"));
}

TEST(SurfaceMotion, AppendingTheWrongLengthIsAnErrorOnAllRanks) {
  const Folder folder;
  const Recorded recorded(0);
  auto file = SurfaceMotionFile::create(folder / "a.h5", header, recorded.surface(), MPI_COMM_WORLD);
  EXPECT_THAT(error_of([&] { file.append(2, std::vector<double>(rank() == 0 ? 3 : 4), {}); }), HasSubstr("expected"));
}

/// Does something to a file on rank 0 alone.
void tamper(const std::filesystem::path& path, const std::function<void(hid_t)>& action) {
  barrier();
  if (rank() == 0) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    action(file);
    H5Fclose(file);
  }
  barrier();
}

TEST(SurfaceMotion, DamagedFilesAreAnswered) {
  const Folder folder;
  const auto path = folder / "plate_surface.h5";
  const auto answer = [&](const std::function<void(hid_t)>& damage) {
    barrier();
    Recorded(0).make(path, {20});
    tamper(path, damage);
    auto error = error_of([&] {
      const SurfaceMotionReader reader(path);
      (void)reader.read_triangles(0, reader.triangles());
    });
    barrier();
    return error;
  };
  EXPECT_EQ(answer([](hid_t) {}), "");
  EXPECT_THAT(answer([](hid_t file) { H5Ldelete(file, "/pressure", H5P_DEFAULT); }),
              HasSubstr("there is no /pressure"));
  EXPECT_THAT(answer([](hid_t file) { H5Adelete(file, "rate"); }), HasSubstr("attribute rate (Hz) is missing"));
  EXPECT_THAT(answer([](hid_t file) {
                const hid_t table = H5Dopen2(file, "/pressure", H5P_DEFAULT);
                const std::array<hsize_t, 2> shape = {19, triangle_count};
                H5Dset_extent(table, shape.data());
                H5Dclose(table);
              }),
              HasSubstr("/pressure has 19 rows and /position 20"));
  EXPECT_THAT(answer([](hid_t file) {
                const hid_t table = H5Dopen2(file, "/triangles", H5P_DEFAULT);
                std::array<std::int32_t, std::size_t{3} * triangle_count> corners{};
                corners[4] = vertex_count;
                H5Dwrite(table, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, corners.data());
                H5Dclose(table);
              }),
              HasSubstr("triangle 1 has vertex 8; there are 8"));
  if (rank() == 0) {
    std::filesystem::resize_file(path, 5000);
  }
  barrier();
  EXPECT_THAT(error_of([&] { SurfaceMotionReader{path}; }), HasSubstr("damaged"));
}

TEST(SurfaceMotion, InfoTellsOfIt) {
  const Folder folder;
  Recorded(0).make(folder / "plate_surface.h5", {20});
  EXPECT_THAT(contents::describe(folder / "plate_surface.h5"),
              ::testing::AllOf(HasSubstr("surface motion of the run 'plate & hammer'"),
                               HasSubstr("20 audio samples at 8000 Hz, the first -6"), HasSubstr("plate, hammer"),
                               HasSubstr("/position"), HasSubstr("[20 x 8 x 3]")));
}

}  // namespace
}  // namespace idiophone::results

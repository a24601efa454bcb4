#include "idiophone/run/record/frame_recorder.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include "checkpointed.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "ranks.hpp"
#include "stages.hpp"

namespace idiophone::record {
namespace {

using namespace support;
using ::testing::ElementsAre;

constexpr int samples_per_frame = 8;

/// All numbers of a dataset.
template <class T>
std::vector<T> read(const std::filesystem::path& path, const std::string& name, hid_t type) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t space = H5Dget_space(dataset);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(dataset);
  H5Fclose(file);
  return values;
}

/// A small plate that is struck, and what its frames should be.
class FrameRecorderTest : public ::testing::Test {
 protected:
  /// From the audio sample `begin` of the bodies' motion on, 0 for the start.
  void record(std::int64_t begin, std::int64_t end) {
    for (std::int64_t moved = begin; moved < end; ++moved) {
      moved == 0 ? source_.start(motion_) : source_.advance(motion_);
      recorder_.note(source_.first_sample() + moved, motion_);
      if (moved % samples_per_frame == 0) {
        expected_.push_back(displacement());
      }
    }
    recorder_.write();
    result_.flush();
    barrier();
  }

  /// Of this rank's nodes now, m.
  [[nodiscard]] std::vector<float> displacement() const {
    std::vector<float> values;
    const mesh::BodyPart& body = ready_.part.bodies[0];
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const auto& u = source_.motion().state()[node].displacement;
      values.insert(values.end(), u, u + 3);
    }
    return values;
  }

  /// Of this rank's nodes in a frame of the result, m.
  [[nodiscard]] std::vector<float> stored(std::size_t frame) const {
    const auto all = read<float>(path_, "/frames/plate/displacement", H5T_NATIVE_FLOAT);
    std::vector<float> values;
    const mesh::BodyPart& body = ready_.part.bodies[0];
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const auto first = all.begin() + 3 * (static_cast<std::ptrdiff_t>(frame) * ready_.part.global_nodes +
                                            ready_.part.node_ids[node]);
      values.insert(values.end(), first, first + 3);
    }
    return values;
  }

  [[nodiscard]] std::vector<double> times() const { return read<double>(path_, "/frames/time", H5T_NATIVE_DOUBLE); }

  Folder folder_;
  std::filesystem::path path_ = folder_ / "simple.h5";
  results::ResultFile result_ = results::ResultFile::create(path_, {"simple", "version", "deck", {}}, MPI_COMM_WORLD);
  bodies::Preparation ready_ = bodies::prepare(
      scene::read_deck(IDIOPHONE_SOURCE_DIR "/ctest/app/decks/simple.yaml", {"time.duration=0.0035"}), MPI_COMM_WORLD);
  bodies::FiniteElementSource source_{ready_, stages(), MPI_COMM_WORLD};
  surface::SurfaceMotion motion_;
  FrameRecorder recorder_{ready_, source_, result_, MPI_COMM_WORLD};
  std::vector<std::vector<float>> expected_;  ///< [frames]
};

ON_RANKS(1, 3);

TEST_F(FrameRecorderTest, WritesDisplacementsAtTheFrameRateUntilTheSoundEnds) {
  recorder_.declare();
  record(0, 11);
  record(11, 60);  // the sound has 28 samples
  EXPECT_THAT(times(), ElementsAre(0.0, 0.001, 0.002, 0.003));
  for (std::size_t frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(stored(frame), expected_.at(frame)) << frame;
  }
  const auto plate = read<float>(path_, "/frames/plate/displacement", H5T_NATIVE_FLOAT);
  EXPECT_NE(plate, std::vector<float>(plate.size()));  // it moves
}

TEST_F(FrameRecorderTest, WritesTheMesh) {
  recorder_.declare();
  record(0, 1);
  const auto nodes = read<double>(path_, "/mesh/plate/nodes", H5T_NATIVE_DOUBLE);
  ASSERT_EQ(std::ssize(nodes), 3 * ready_.part.global_nodes);
  const mesh::BodyPart& body = ready_.part.bodies[0];
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(nodes[3 * ready_.part.node_ids[node] + axis], ready_.part.reference[node][axis]);
    }
  }
  const auto elements = read<std::int32_t>(path_, "/mesh/plate/elements", H5T_NATIVE_INT32);
  EXPECT_EQ(std::ssize(elements), 10 * ready_.part.global_elements);
}

TEST_F(FrameRecorderTest, GoesOnWhereTheResultWasCutBackTo) {
  recorder_.declare();
  record(0, 9);
  const auto checkpoint = save(folder_, result_);
  record(9, 17);
  restore(checkpoint, MPI_COMM_WORLD, result_);
  EXPECT_THAT(times(), ElementsAre(0.0, 0.001));
  record(17, 25);
  EXPECT_THAT(times(), ElementsAre(0.0, 0.001, 0.003));
  EXPECT_EQ(stored(2), expected_.at(3));
}

}  // namespace
}  // namespace idiophone::record

#include "idiophone/run/record/channel_recorder.hpp"

#include <gmock/gmock.h>

#include "checkpointed.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "ranks.hpp"

namespace idiophone::record {
namespace {

using namespace support;
using ::testing::ElementsAre;

/// Two channels of one measurement; rows are on rank 0 only.
class Pendulum : public bodies::ChannelGroup {
 public:
  Pendulum()
      : ChannelGroup({{"/pendulum/angle", "rad", 100.0, {"angle"}, "angle from the vertical", {}},
                      {"/pendulum/energy", "J", 50.0, {"kinetic", "potential"}, "energies", {}}}) {}

  void note(std::int64_t sample) override {
    if (rank() == 0) {
      const auto value = static_cast<double>(sample);
      rows_[0].push_back(value);
      rows_[1].insert(rows_[1].end(), {value, -value});
    }
  }
  std::vector<std::vector<double>> collect() override { return std::exchange(rows_, {{}, {}}); }

 private:
  std::vector<std::vector<double>> rows_{2};
};

class ChannelRecorderTest : public ::testing::Test {
 protected:
  void record(std::int64_t begin, std::int64_t end) {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      pendulum_.note(sample);
    }
    recorder_.write();
    result_.flush();
    barrier();
  }

  [[nodiscard]] std::vector<double> rows(const std::string& name) const {
    const results::SeriesReader reader(path_);
    return reader.read(reader.find(name));
  }

  Folder folder_;
  std::filesystem::path path_ = folder_ / "pendulum.h5";
  results::ResultFile result_ = results::ResultFile::create(path_, {"pendulum", "version", "deck", {}}, MPI_COMM_WORLD);
  Pendulum pendulum_;
  bodies::Channels channels_{{&pendulum_}};
  ChannelRecorder recorder_{channels_, result_};
};

ON_RANKS(1, 3);

TEST_F(ChannelRecorderTest, WritesEveryChannelAsItIsInMemory) {
  recorder_.declare();
  record(1, 3);
  record(3, 4);
  const results::SeriesReader reader(path_);
  ASSERT_EQ(reader.all().size(), 2U);
  const spectra::Series& energy = reader.find("pendulum/energy");
  EXPECT_EQ(energy.unit, "J");
  EXPECT_EQ(energy.rate, 50.0);
  EXPECT_EQ(energy.description, "energies");
  EXPECT_THAT(energy.columns, ElementsAre("kinetic", "potential"));
  EXPECT_THAT(rows("pendulum/angle"), ElementsAre(1, 2, 3));
  EXPECT_THAT(rows("pendulum/energy"), ElementsAre(1, -1, 2, -2, 3, -3));
}

TEST_F(ChannelRecorderTest, GoesOnWhereTheResultWasCutBackTo) {
  recorder_.declare();
  record(1, 3);
  const auto checkpoint = save(folder_, result_);
  record(3, 9);
  restore(checkpoint, MPI_COMM_WORLD, result_);
  record(30, 31);
  EXPECT_THAT(rows("pendulum/angle"), ElementsAre(1, 2, 30));
}

}  // namespace
}  // namespace idiophone::record

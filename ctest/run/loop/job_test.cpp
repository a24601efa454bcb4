// A job of two plates that sound under a given pressure: its files, its stop, and how it goes on.

#include "idiophone/run/loop/job.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "ranks.hpp"
#include "stages.hpp"
#include "two_plates.hpp"

namespace idiophone::loop {
namespace {

using namespace support;

constexpr std::int64_t sound_samples = 100;

/// Plates at rest whose pressure is a sine.
class SoundingPlates : public bodies::Source {
 public:
  SoundingPlates() : Source(two_plates()) {}
  [[nodiscard]] std::int64_t first_sample() const override { return -2; }
  void start(surface::SurfaceMotion& motion) override { give(motion); }
  void advance(surface::SurfaceMotion& motion) override {
    ++advanced_;
    give(motion);
  }
  void archive(parallel::Archive& archive) override { archive.root("plates/advanced", advanced_); }

 private:
  void give(surface::SurfaceMotion& motion) const {
    motion = at_rest(surface(), 0.0);
    std::fill_n(motion.pressure.begin(), surface().triangles.size(), std::sin(0.3 * static_cast<double>(advanced_)));
  }

  std::int64_t advanced_ = 0;
};

/// Counts what happens to it, and makes blocks short.
class CountingRecorder : public record::Recorder {
 public:
  struct Counts {
    int declared = 0, begun = 0, finished = 0;
  };
  explicit CountingRecorder(Counts& counts) : counts_(counts) {}
  void declare() override { ++counts_.declared; }
  void begin() override { ++counts_.begun; }
  void note(std::int64_t /*sample*/, const surface::SurfaceMotion& /*motion*/) override {}
  void write() override {}
  void finish() override { ++counts_.finished; }
  void archive(parallel::Archive& /*archive*/) override {}
  [[nodiscard]] std::int64_t longest_block() const override { return 10; }

 private:
  Counts& counts_;
};

class JobTest : public ::testing::Test {
 protected:
  JobTest() {
    scene_.name = "plates";
    scene_.audio = {.rate = 8000, .dc_loss = 0.1};
    scene_.radiation.model = scene::RadiationModel::huygens;  // its first block has sound
    scene::Listener& listener = scene_.listeners.emplace_back();
    listener.name = "ear";
    listener.receivers = {{.channel = "ear", .position = Vector3(0.1, 0.2, 1.5)}};
    scene_.radiation.visibility = scene::VisibilityUpdates{1000.0};
  }

  enum class Begin { anew, resumed };

  /// In a folder of the tests' own, which is made.
  /// @param limit  of wall clock, s
  [[nodiscard]] JobEnding perform(const std::string& folder, std::optional<double> limit = {},
                                  Begin begin = Begin::anew) {
    SoundingPlates plates;
    const std::filesystem::path path = folder_ / folder;
    std::filesystem::create_directories(path);
    barrier();
    const auto facts = [&] {
      ++asked_for_facts_;
      return nlohmann::json::object();
    };
    const auto recorders = [&](results::ResultFile& /*result*/) {
      record::Recorders all;
      all.push_back(std::make_unique<CountingRecorder>(counts_));
      return all;
    };
    const JobEnding ending =
        loop::perform({.scene = scene_,
                       .source = plates,
                       .stages = stages(),
                       .folder = path,
                       .sound_samples = sound_samples,
                       .facts = facts,
                       .wall_clock_limit = limit,
                       .checkpoints = JobCheckpoints{{"version", "mesh", "deck", {}},
                                                     {{path / "plates.h5", results::ResultFile::archive_prefix}},
                                                     begin == Begin::resumed},
                       .recorders = recorders},
                      MPI_COMM_WORLD);
    barrier();
    return ending;
  }

  [[nodiscard]] std::vector<double> sound_in(const std::string& folder) const {
    const results::SeriesReader reader(folder_ / folder / "plates.h5");
    return reader.read(reader.find("audio/ear"));
  }

  Folder folder_;
  scene::Scene scene_;
  CountingRecorder::Counts counts_;
  int asked_for_facts_ = 0;
};

ON_RANKS(1, 3);

TEST_F(JobTest, GoesToTheEndAndWritesTheSound) {
  EXPECT_EQ(perform("whole").status, exit_finished);
  const std::vector<double> sound = sound_in("whole");
  EXPECT_EQ(sound.size(), sound_samples);
  EXPECT_GT(std::abs(*std::ranges::max_element(sound, {}, [](double value) { return std::abs(value); })), 0.0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "whole" / "plates.wav"));
  EXPECT_EQ(asked_for_facts_, 1);
  EXPECT_EQ(counts_.declared, 1);
  EXPECT_EQ(counts_.begun, 1);
  EXPECT_EQ(counts_.finished, 1);
}

TEST_F(JobTest, StopsAtTheLimitAndGoesOnWithTheSameBits) {
  static_cast<void>(perform("whole"));
  counts_ = {};
  asked_for_facts_ = 0;
  EXPECT_EQ(perform("parts", 0.0).status, exit_resumable);
  EXPECT_LT(sound_in("parts").size(), sound_samples);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "parts" / "plates.wav"));
  EXPECT_EQ(counts_.finished, 0);
  EXPECT_EQ(perform("parts", {}, Begin::resumed).status, exit_finished);
  EXPECT_EQ(sound_in("parts"), sound_in("whole"));
  EXPECT_EQ(asked_for_facts_, 1) << "a resumed job has facts already";
  EXPECT_EQ(counts_.declared, 1);
  EXPECT_EQ(counts_.begun, 2);
  EXPECT_EQ(counts_.finished, 1);
}

TEST_F(JobTest, SaysWhatToDoWhereTheResultIsGone) {
  static_cast<void>(perform("parts", 0.0));
  if (rank() == 0) {
    std::filesystem::remove(folder_ / "parts" / "plates.h5");
  }
  barrier();
  EXPECT_THROW(static_cast<void>(perform("parts", {}, Begin::resumed)), std::runtime_error);
}

TEST(InstructionSet, IsTheSameOnAllRanks) {
  EXPECT_NO_THROW(require_one_instruction_set("AVX2", MPI_COMM_WORLD));
  if (parallel::size_of(MPI_COMM_WORLD) > 1) {
    const std::string own = parallel::is_root(MPI_COMM_WORLD) ? "AVX2" : "AVX-512";
    EXPECT_THROW(require_one_instruction_set(own, MPI_COMM_WORLD), std::runtime_error);
  }
}

}  // namespace
}  // namespace idiophone::loop

#include "idiophone/run/record/sound.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "checkpointed.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"
#include "stages.hpp"
#include "two_plates.hpp"

namespace idiophone::record {
namespace {

using namespace support;
using propagation::AudioPath;
using ::testing::Each;
using ::testing::HasSubstr;

constexpr std::int64_t steady = -2;  // audio sample of the steady motion

/// Two plates, and a listener above them.
class AudioPathTest : public ::testing::Test {
 protected:
  AudioPathTest() {
    scene_.audio = {.rate = 8000, .dc_loss = 0.1};
    scene_.radiation.model = scene::RadiationModel::huygens;  // its latency is short
    scene::Listener& listener = scene_.listeners.emplace_back();
    listener.name = "ear";
    listener.receivers = {{.channel = "ear", .position = Vector3(0.1, 0.2, 1.5)}};
    scene_.radiation.visibility = scene::VisibilityUpdates{1000.0};
  }

  /// All plates at rest, under a pressure (Pa).
  [[nodiscard]] surface::SurfaceMotion motion(double pressure) const {
    surface::SurfaceMotion motion = at_rest(surface_, 0.0);
    std::fill_n(motion.pressure.begin(), surface_.triangles.size(), pressure);
    return motion;
  }

  [[nodiscard]] AudioPath make_path() const { return {scene_, surface_, steady, stages(), MPI_COMM_WORLD}; }

  /// A new result with the path's series.
  [[nodiscard]] results::ResultFile make_result(const std::string& name, const AudioPath& path) const {
    auto result = results::ResultFile::create(folder_ / name, {"plates", "version", "deck", {}}, MPI_COMM_WORLD);
    declare_sound(path, result);
    return result;
  }

  /// Plates that sound, in audio samples counted from the one after the steady motion.
  void hear(AudioPath& path, std::int64_t begin, std::int64_t end) const {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      path.hear(motion(std::sin(0.3 * static_cast<double>(sample))));
    }
    path.check();
  }

  /// The sound in a result.
  [[nodiscard]] std::vector<double> sound_in(results::ResultFile& result, const std::string& name) const {
    result.flush();
    barrier();
    const results::SeriesReader reader(folder_ / name);
    return reader.read(reader.find("audio/ear"));
  }

  Folder folder_;
  scene::Scene scene_;
  propagation::AudibleSurface surface_ = two_plates();
};

ON_RANKS(1, 3);

TEST_F(AudioPathTest, ConstantPressureIsSilent) {
  AudioPath path = make_path();
  results::ResultFile result = make_result("silent.h5", path);
  path.start(motion(5.0));
  for (int i = 0; i < 50; ++i) {
    path.hear(motion(5.0));
  }
  path.check();
  write_sound(path, 1000, result);
  const auto sound = sound_in(result, "silent.h5");
  EXPECT_GT(sound.size(), 30U);
  EXPECT_THAT(sound, Each(0.0));
  EXPECT_EQ(path.loudest(), 0.0);
}

TEST_F(AudioPathTest, KnowsTheLoudestSample) {
  AudioPath path = make_path();
  results::ResultFile result = make_result("loud.h5", path);
  path.start(motion(0.0));
  hear(path, 0, 60);
  write_sound(path, 1000, result);
  double loudest = 0.0;
  for (const double value : sound_in(result, "loud.h5")) {
    loudest = std::max(loudest, std::abs(value));
  }
  EXPECT_GT(loudest, 0.1);
  if (rank() == 0) {
    EXPECT_EQ(path.loudest(), loudest);
  }
}

TEST_F(AudioPathTest, AMotionThatIsNotFiniteIsReportedOnAllRanks) {
  AudioPath path = make_path();
  path.start(motion(0.0));
  surface::SurfaceMotion broken = motion(0.0);
  if (!surface_.triangles.empty() && surface_.triangle_ids.back() == 3) {
    broken.pressure[surface_.triangles.size() - 1] = std::numeric_limits<double>::quiet_NaN();
  }
  path.hear(broken);
  path.hear(motion(0.0));
  EXPECT_THAT(error_of([&] { path.check(); }), HasSubstr("the motion can't be heard"));
}

TEST_F(AudioPathTest, WritesNoMoreThanWhatIsFinalAndAskedFor) {
  AudioPath path = make_path();
  results::ResultFile result = make_result("most.h5", path);
  path.start(motion(0.0));
  const std::int64_t enough = path.completing_sample(40) - steady;
  hear(path, 0, enough - 1);
  for (const auto& [most, written] : {std::pair(10, 10U), std::pair(10, 10U), std::pair(5, 10U), std::pair(99, 39U)}) {
    write_sound(path, most, result);
    EXPECT_EQ(sound_in(result, "most.h5").size(), written);
  }
  hear(path, enough - 1, enough);
  write_sound(path, 99, result);
  EXPECT_EQ(sound_in(result, "most.h5").size(), 40U);
}

TEST_F(AudioPathTest, GoesOnFromAnArchiveWithTheSameBits) {
  for (const auto model : {scene::RadiationModel::huygens, scene::RadiationModel::kirchhoff}) {
    scene_.radiation.model = model;
    surface_.radii.assign(surface_.triangles.size(), 0.3);
    AudioPath path = make_path();
    results::ResultFile result = make_result("whole.h5", path);
    path.start(motion(0.0));
    hear(path, 0, 37);
    write_sound(path, 1000, result);
    const std::size_t before = sound_in(result, "whole.h5").size();
    const auto checkpoint = save(folder_, path);
    hear(path, 37, 90);
    write_sound(path, 1000, result);
    const auto whole = sound_in(result, "whole.h5");

    AudioPath resumed = make_path();
    results::ResultFile rest = make_result("rest.h5", resumed);
    restore(checkpoint, MPI_COMM_WORLD, resumed);
    hear(resumed, 37, 90);
    write_sound(resumed, 1000, rest);
    EXPECT_EQ(sound_in(rest, "rest.h5"), std::vector(whole.begin() + static_cast<std::ptrdiff_t>(before), whole.end()));
    if (rank() == 0) {
      EXPECT_EQ(resumed.loudest(), path.loudest());
    }
  }
}

}  // namespace
}  // namespace idiophone::record

// Objects between sounds and listeners, and sounds that are not the same in all directions, by exact gains and delays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "amplitude.hpp"
#include "box.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "ranks.hpp"
#include "temporary_file.hpp"

namespace idiophone::timbre {

namespace {

constexpr double impedance = 1.21 * 343.0;  // of the air of a deck, Pa s/m
constexpr std::size_t one_second = 44100;

TrackObject standing(const Vector3& centre, const Vector3& size) {
  return {.size = size, .pose = [centre](double /*time*/) { return TrackObject::Pose{.centre = centre}; }};
}

}  // namespace

class ObjectsTest : public testing::Test {
 protected:
  ObjectsTest() {
    scene_.audio.rate = 44100;
    scene_.radiation.model = scene::RadiationModel::rayleigh;
    listen_at({4, 0, 0});
  }

  void listen_at(const Vector3& position) {
    scene::Listener listener;
    listener.name = "ear";
    listener.receivers.push_back({.channel = "ear", .position = position});
    scene_.listeners = {listener};
  }

  /// What the listener hears of a sine.
  [[nodiscard]] std::vector<double> heard(double frequency, double duration = 0.3) const {
    const support::TemporaryFile tree("sine.tt", "(parameter f) (sine f)");
    Soundtrack track(scene_, 1);
    const SoundHandle sound = track.instantiate_sound(track.timbre_tree(tree.path()), 1.0, source_, aim_);
    track.start_sound(sound, 0.0, {{"f", {.value = frequency, .where = {}}}});
    for (const TrackObject& object : objects_) {
      track.add_object(object);
    }
    return track.render(duration, reverberation_).front().samples;
  }

  [[nodiscard]] double heard_amplitude(double frequency) const {
    return amplitude(heard(frequency), frequency, 4410, 13230);
  }

  scene::Scene scene_;
  Soundtrack::Path source_ = [](double /*time*/) -> Vector3 { return {0, 0, 0}; };
  std::optional<Soundtrack::Aim> aim_;
  std::vector<TrackObject> objects_;
  std::optional<Reverberation> reverberation_;
};

namespace {

Soundtrack::Aim aimed(const Directivity& directivity, const Vector3& axis) {
  return {.directivity = directivity, .axis = [axis](double /*time*/) { return axis; }};
}

/// The largest difference of two sounds.
double difference(const std::vector<double>& one, const std::vector<double>& other) {
  double most = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    most = std::max(most, std::abs(one[i] - other[i]));
  }
  return most;
}

}  // namespace

ON_RANKS(1);

TEST_F(ObjectsTest, ARigidBlockReflectsAsAFloor) {
  source_ = [](double time) -> Vector3 { return {0.5 * time, 0.3, 1.5 + time}; };
  listen_at({4, 0, 1});
  scene_.radiation.floor = scene::Floor{.reflection = 0.6};
  const auto by_floor = heard(500);
  scene_.radiation.floor.reset();
  const auto free = heard(500);
  objects_ = {standing({2, 0, -1}, {20, 20, 2})};
  objects_[0].absorption = 1.0 - 0.6 * 0.6;
  EXPECT_LT(difference(heard(500), by_floor), 1e-9);
  EXPECT_GT(difference(free, by_floor), 0.05);
}

TEST_F(ObjectsTest, AReflectionHasTheGainAndDelayOfTheImage) {
  objects_ = {standing({2, 3.5, 0}, {3, 1, 3})};  // its face is 3 m beside source and listener
  const auto sound = heard(441);
  const double longer = std::hypot(4.0, 6.0);
  for (std::size_t i = 2000; i < 8000; ++i) {
    const double time = static_cast<double>(i) / 44100.0, turn = 2.0 * std::numbers::pi * 441.0;
    ASSERT_NEAR(sound[i], std::sin(turn * (time - 4.0 / 343)) / 4 + std::sin(turn * (time - longer / 343)) / longer,
                1e-4);
  }
}

TEST_F(ObjectsTest, NothingIsReflectedBesideAFaceOrBehindAnotherObject) {
  const auto free = heard(441);
  objects_ = {standing({4, 3.5, 0}, {3, 1, 3})};  // the image is seen past its edge
  EXPECT_LT(difference(heard(441), free), 1e-12);
  objects_ = {standing({2, 3.5, 0}, {3, 1, 3})};
  EXPECT_GT(difference(heard(441), free), 0.1);
  objects_.push_back(standing({1, 1.5, 0}, {0.1, 0.1, 0.1}));
  EXPECT_LT(difference(heard(441), free), 1e-12);  // it stands in the way to the face
}

TEST_F(ObjectsTest, RigidObjectsInTheWayAreSilence) {
  objects_ = {standing({2, 0, 0}, {0.2, 1, 1})};
  EXPECT_LT(heard_amplitude(1000), 1e-9);
  listen_at({4, 1.2, 0});  // past it
  EXPECT_NEAR(heard_amplitude(1000), 1.0 / std::hypot(4, 1.2), 1e-3);
}

TEST_F(ObjectsTest, WallsLetThroughWhatTheMassLawSays) {
  objects_ = {standing({2, 0, 0}, {0.1, 100, 100})};
  for (const double angle : {0.0, 0.9}) {
    source_ = [angle](double /*time*/) -> Vector3 { return {0, 4 * std::tan(angle), 0}; };
    const double distance = 4.0 / std::cos(angle);
    for (const double density : {1.0, 20.0}) {
      objects_[0].surface_density = density;
      for (const double frequency : {100.0, 500.0, 1000.0, 4000.0}) {
        const double ratio = std::numbers::pi * frequency * density * std::cos(angle) / impedance;
        const double loss = -20.0 * std::log10(heard_amplitude(frequency) * distance);  // dB
        EXPECT_NEAR(loss, 10.0 * std::log10(1.0 + ratio * ratio), 0.15) << angle << " " << density << " " << frequency;
      }
    }
  }
}

TEST_F(ObjectsTest, LossesOfTwoWallsAddUp) {
  objects_ = {standing({1, 0, 0}, {0.1, 1, 1})};
  objects_[0].surface_density = 5.0;
  const double one = 4.0 * heard_amplitude(1000);
  objects_.push_back(standing({3, 0, 0}, {0.1, 1, 1}));
  objects_[1].surface_density = 5.0;
  EXPECT_NEAR(4.0 * heard_amplitude(1000) / (one * one), 1.0, 0.01);
}

TEST_F(ObjectsTest, AWallReflectsTheEnergyThatDoesNotPass) {
  const auto free = heard(300);
  objects_ = {standing({5.1, 0, 0}, {2, 20, 20})};  // 0.1 m behind the listener
  objects_[0].surface_density = 1.0;
  auto reflected = heard(300);
  for (std::size_t i = 0; i < free.size(); ++i) {
    reflected[i] -= free[i];
  }
  const double ratio = std::numbers::pi * 300.0 / impedance;
  const double expected = ratio / std::sqrt(1.0 + ratio * ratio) / 4.2;
  EXPECT_NEAR(amplitude(reflected, 300, 4410, 13230) / expected, 1.0, 0.03);
}

TEST_F(ObjectsTest, SoundsFadeBehindAnObject) {
  source_ = [](double time) -> Vector3 { return {0, 10 * time - 1.5, 0}; };  // in its shadow from -0.5 m to 0.5 m
  objects_ = {standing({2, 0, 0}, {0.01, 0.5, 1})};
  const auto sound = heard(441, 0.3);
  double step = 0.0;
  for (std::size_t i = 3000; i < sound.size(); ++i) {
    step = std::max(step, std::abs(sound[i] - sound[i - 1]));
  }
  EXPECT_LT(step, 1.2 * 0.25 * 2.0 * std::numbers::pi * 441.0 / 44100.0);  // no more than the sine itself
  const auto shadow = static_cast<std::size_t>((0.15 + 4.0 / 343) * 44100);
  EXPECT_LT(amplitude(sound, 441, shadow - 200, shadow + 200), 1e-6);
  EXPECT_GT(amplitude(sound, 441, 3000, 4000), 0.2);
}

TEST_F(ObjectsTest, AnObjectDoesNotShadeItsOwnSounds) {
  objects_ = {standing({0, 0, 0}, {1, 1, 1})};
  EXPECT_LT(heard_amplitude(1000), 1e-9);  // the source is inside
  objects_[0].own = {SoundHandle{0}};
  EXPECT_NEAR(heard_amplitude(1000), 0.25, 1e-3);
}

TEST_F(ObjectsTest, SoundsAreLoudestOnTheirAxis) {
  const Vector3 diagonal = Vector3(1, 1, 0).normalized();
  const auto level = [&](const Directivity& directivity, const Vector3& axis) {
    aim_ = aimed(directivity, axis);
    return 4.0 * heard_amplitude(1000);
  };
  const Directivity cardioid{.share = 0.5}, eight{.share = 1.0}, horn{.levels = {{0, 0}, {90, -20}, {180, -30}}};
  EXPECT_NEAR(level(cardioid, {1, 0, 0}), 1.0, 1e-3);
  EXPECT_NEAR(level(cardioid, {0, 1, 0}), 0.5, 1e-3);
  EXPECT_NEAR(level(cardioid, {-1, 0, 0}), 0.0, 1e-6);
  EXPECT_NEAR(level(eight, {0, 0, 1}), 0.0, 1e-6);
  EXPECT_NEAR(level(eight, diagonal), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(level(horn, {1, 0, 0}), 1.0, 1e-3);
  EXPECT_NEAR(20.0 * std::log10(level(horn, diagonal)), -10.0, 0.02);
  EXPECT_NEAR(20.0 * std::log10(level(horn, {-1, 0, 0})), -30.0, 0.02);
}

TEST_F(ObjectsTest, ReflectionsAreThoseOfAnAimedSound) {
  aim_ = aimed({.share = 1.0}, {0, 1, 0});  // silent towards the listener, loud towards the block
  objects_ = {standing({2, 3.5, 0}, {3, 1, 3})};
  const double longer = std::hypot(4.0, 6.0);
  EXPECT_NEAR(heard_amplitude(1000), 6.0 / longer / longer, 1e-3);
}

TEST_F(ObjectsTest, ADiffuseFieldHearsTheMeanOfAllDirections) {
  EXPECT_NEAR(Directivity{.share = 0.5}.diffuse_gain(), std::sqrt(1.0 / 3.0), 1e-5);
  EXPECT_NEAR(Directivity{.share = 1.0}.diffuse_gain(), std::sqrt(1.0 / 3.0), 1e-5);
  reverberation_ = Reverberation{.decay = 0.5, .level = 1.0};
  aim_ = aimed({.share = 1.0}, {0, 0, 1});  // no direct sound
  const auto late = heard(1000);
  aim_ = aimed({.share = 1.0}, {0, 1, 0});
  EXPECT_LT(difference(heard(1000), late), 1e-9);
  EXPECT_GT(amplitude(late, 1000, 4410, 13230), 0.0);
}

TEST(Boxes, AreCrossedAtTheFaceWhereAWayEnters) {
  const Box box{.centre = {1, 2, 3}, .half = {1, 2, 3}};
  const auto entry = box.crossing({-3, 2, 3}, {5, 2, 3});
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->face, (Box::Face{0, -1.0}));
  EXPECT_EQ(entry->point, Vector3(0, 2, 3));
  EXPECT_EQ(entry->cosine, 1.0);
  const auto exit = box.crossing({1, 2, 3}, {1, 9, 3});
  ASSERT_TRUE(exit);
  EXPECT_EQ(exit->face, (Box::Face{1, 1.0}));
  EXPECT_FALSE(box.crossing({1, 2, 3}, {1, 3, 3}));   // inside
  EXPECT_FALSE(box.crossing({2, 2, 3}, {9, 2, 3}));   // begins on a face
  EXPECT_FALSE(box.crossing({2, -9, 3}, {2, 9, 3}));  // along a face
  EXPECT_FALSE(box.crossing({-3, 2, 3}, {-1, 2, 3}));
}

}  // namespace idiophone::timbre

// Objects between sounds and listeners, and sounds that are not the same in all directions, by exact gains and delays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "amplitude.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "object_shape.hpp"
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

TEST_F(ObjectsTest, FloorReflectionsAreShaded) {
  source_ = [](double /*time*/) -> Vector3 { return {0, 0, 1.5}; };
  listen_at({4, 0, 1.5});
  const auto direct = heard(500);
  scene_.radiation.floor = scene::Floor{};
  const auto reflected = heard(500);
  EXPECT_GT(difference(reflected, direct), 0.05);
  objects_ = {standing({2, 0, 0.5}, {0.1, 2, 1})};  // below the direct way, across the reflected one
  objects_[0].absorption = 1.0;
  EXPECT_LT(difference(heard(500), direct), 1e-9);
  objects_[0].surface_density = 0.0;
  EXPECT_LT(difference(heard(500), reflected), 1e-3);
  objects_ = {standing({0.5, 0, 0.5}, {0.1, 2, 1})};  // beside both
  objects_[0].absorption = 1.0;
  EXPECT_LT(difference(heard(500), reflected), 1e-9);
}

TEST_F(ObjectsTest, ReflectionsFromTheWallsOfARoomAreShaded) {
  source_ = [](double /*time*/) -> Vector3 { return {1, 3, 1.5}; };
  listen_at({5, 3, 1.5});
  const auto direct = heard(500);
  scene::OctaveBands none{}, all{};
  all.fill(1.0);
  scene::Room room;
  room.size = {6, 6, 4};
  room.absorption = {all, all, all, all, none, all};
  room.late = false;
  scene_.radiation.room = room;
  const auto reflected = heard(500);  // by the floor of the room alone
  EXPECT_GT(difference(reflected, direct), 0.05);
  objects_ = {standing({3, 3, 0.5}, {0.1, 2, 1})};
  objects_[0].absorption = 1.0;
  EXPECT_LT(difference(heard(500), direct), 1e-9);
  scene_.radiation.room->absorption[5] = none;  // its ceiling, and echoes between both
  scene_.radiation.room->images = 3;
  objects_ = {standing({3, 3, 2}, {0.1, 6, 4})};  // from wall to wall
  objects_[0].absorption = 1.0;
  EXPECT_LT(heard_amplitude(500), 1e-6);
}

TEST_F(ObjectsTest, TheLateSoundOfASoundInsideAnObjectIsBehindItsWall) {
  reverberation_ = Reverberation{.decay = 0.5, .level = 1.0};
  source_ = [](double /*time*/) -> Vector3 { return {0, 0, 0}; };
  aim_ = aimed({.share = 1.0}, {0, 0, 1});  // nothing but late sound reaches the listener
  const auto late = heard(500);
  objects_ = {standing({2, 0, 0}, {0.1, 100, 100})};
  objects_[0].absorption = 1.0;
  EXPECT_EQ(difference(heard(500), late), 0.0) << "it comes from all sides";
  objects_ = {standing({0, 0, 0}, {1, 1, 1})};
  EXPECT_LT(heard_amplitude(500), 1e-9);
  objects_[0].surface_density = 2.0;
  const double ratio = 500.0 * std::numbers::pi * 2.0 * (2.0 / 3.0) / impedance;
  EXPECT_NEAR(heard_amplitude(500) / amplitude(late, 500, 4410, 13230), 1.0 / std::hypot(1.0, ratio), 0.01);
}

namespace {

std::vector<ObjectShape::Triangle> triangles_of_box(const Vector3& size) {
  std::vector<ObjectShape::Triangle> triangles;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const auto corner = [&](double b, double c) -> Vector3 {
        Vector3 point = Vector3::Zero();
        point[axis] = sign * size[axis] / 2.0;
        point[(axis + 1) % 3] = b * size[(axis + 1) % 3] / 2.0;
        point[(axis + 2) % 3] = sign * c * size[(axis + 2) % 3] / 2.0;
        return point;
      };
      triangles.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
      triangles.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
    }
  }
  return triangles;
}

/// A prism of height 2 about z = 0 with this base, which is a star seen from its first corner.
ObjectShape prism(const std::vector<std::array<double, 2>>& base) {
  const auto at = [&](std::size_t i, double z) -> Vector3 {
    return {base[i % base.size()][0], base[i % base.size()][1], z};
  };
  std::vector<ObjectShape::Triangle> triangles;
  for (std::size_t i = 0; i < base.size(); ++i) {
    triangles.push_back({at(i, -1), at(i + 1, -1), at(i + 1, 1)});
    triangles.push_back({at(i, -1), at(i + 1, 1), at(i, 1)});
    if (i > 0 && i + 1 < base.size()) {
      triangles.push_back({at(0, 1), at(i, 1), at(i + 1, 1)});
      triangles.push_back({at(0, -1), at(i + 1, -1), at(i, -1)});
    }
  }
  return ObjectShape(triangles);
}

}  // namespace

TEST_F(ObjectsTest, SolidsOfTrianglesAreHeardAsTheBoxThatTheyAre) {
  objects_ = {standing({2, 0.3, 0}, {0.1, 2, 2}), standing({2, 3.5, 0}, {3, 1, 3})};
  objects_[0].surface_density = 3.0;
  const auto boxes = heard(441);
  for (TrackObject& object : objects_) {
    object.triangles = triangles_of_box(object.size);
    object.size = Vector3::Constant(0.01);
  }
  EXPECT_LT(difference(heard(441), boxes), 1e-12);
}

TEST_F(ObjectsTest, SoundsAreAimedInEachOctaveBandByItself) {
  const Directivity omni, eight{.share = 1.0}, cardioid{.share = 0.5};
  Directivity all;
  all.bands.assign(6, omni);
  const auto plain = heard(1000);
  aim_ = aimed(all, {1, 0, 0});
  const auto level = [](const std::vector<double>& sound, double frequency) {
    return 4.0 * amplitude(sound, frequency, 4410, 13230);
  };
  EXPECT_LT(difference(heard(1000), plain), 1e-9) << "the bands add up, and nothing is late";
  all.bands = {omni, omni, cardioid, eight, omni, cardioid};  // 125, 250, 500, 1000, 2000, 4000 Hz
  aim_ = aimed(all, {0, 1, 0});                               // the listener is beside it
  EXPECT_NEAR(level(heard(100), 100), 1.0, 0.01);
  EXPECT_NEAR(level(heard(250), 250), 1.0, 0.03);
  EXPECT_NEAR(level(heard(500), 500), 0.5, 0.02);
  EXPECT_NEAR(level(heard(1000), 1000), 0.0, 0.02);
  EXPECT_NEAR(level(heard(2000), 2000), 1.0, 0.02);
  EXPECT_NEAR(level(heard(4000), 4000), 0.5, 0.01);
  EXPECT_NEAR(level(heard(12000), 12000), 0.5, 0.01);
  EXPECT_NEAR(level(heard(std::sqrt(2.0) * 2000), std::sqrt(2.0) * 2000), 0.75, 0.01) << "between two centres";
  reverberation_ = Reverberation{.decay = 0.5, .level = 1.0};
  const double among_all = amplitude(heard(4000), 4000, 8820, 13230);
  aim_ = aimed(cardioid, {0, 1, 0});
  EXPECT_NEAR(among_all / amplitude(heard(4000), 4000, 8820, 13230), 1.0, 0.01);
}

TEST(ObjectShapes, AreCrossedAtTheFaceWhereAWayEnters) {
  ObjectShape box = ObjectShape::box({2, 4, 6});
  box.place({1, 2, 3}, Eigen::Matrix3d::Identity());
  const auto entry = box.crossing({-3, 2, 3}, {5, 2, 3});
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->face, 1U);
  EXPECT_LT((entry->point - Vector3(0, 2, 3)).norm(), 1e-12);
  EXPECT_NEAR(entry->cosine, 1.0, 1e-12);
  const auto exit = box.crossing({1, 2, 3}, {1, 9, 3});
  ASSERT_TRUE(exit);
  EXPECT_EQ(exit->face, 2U);
  EXPECT_FALSE(box.crossing({1, 2, 3}, {1, 3, 3}));   // inside
  EXPECT_FALSE(box.crossing({2, 2, 3}, {9, 2, 3}));   // begins on a face
  EXPECT_FALSE(box.crossing({2, -9, 3}, {2, 9, 3}));  // along a face
  EXPECT_FALSE(box.crossing({2, 4, -9}, {2, 4, 9}));  // along an edge
  EXPECT_FALSE(box.crossing({-3, 2, 3}, {-1, 2, 3}));
  EXPECT_TRUE(box.contains({1.9, 3.9, 5.9}));
  EXPECT_FALSE(box.contains({2.1, 3.9, 5.9}));
}

TEST(ObjectShapes, MayBeHollow) {
  // An L: the corner at [1, 1] looks into its inner angle, and all of it is seen from there.
  const ObjectShape shape = prism({{1, 1}, {0, 1}, {0, 0}, {3, 0}, {3, 1}});
  ObjectShape angle = prism({{1, 1}, {1, 3}, {0, 3}, {0, 0}, {3, 0}, {3, 1}});
  EXPECT_TRUE(shape.contains({2, 0.5, 0}));
  EXPECT_TRUE(angle.contains({0.5, 2.5, 0}));
  EXPECT_FALSE(angle.contains({2, 2, 0}));
  EXPECT_FALSE(angle.crossing({2, 1.5, 0}, {1.5, 2, 0}));
  const auto entry = angle.crossing({2.5, 2.5, 0}, {0.5, 0.5, 0});
  ASSERT_TRUE(entry);
  EXPECT_LT((entry->point - Vector3(1, 1, 0)).norm(), 1e-6);
  const auto through_both = angle.crossing({2.5, -1, 0}, {-1, 2.5, 0});
  ASSERT_TRUE(through_both);
  EXPECT_LT((through_both->point - Vector3(1.5, 0, 0)).norm(), 1e-12);
  const auto reflection = angle.reflection({2, 2, 0}, {1.5, 2, 0});
  ASSERT_TRUE(reflection);
  EXPECT_LT((reflection->point - Vector3(1, 2, 0)).norm(), 1e-12) << "the shorter way of two";
  EXPECT_FALSE(angle.reflection({-1, 4, 0}, {4, -1, 0}));
}

}  // namespace idiophone::timbre

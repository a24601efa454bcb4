#include "idiophone/timbre/track/soundtrack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "amplitude.hpp"
#include "diffuse_field.hpp"
#include "ranks.hpp"
#include "recorded_motion.hpp"
#include "sounding.hpp"
#include "track_renderer.hpp"

namespace idiophone::timbre {

namespace {

using std::numbers::pi;

class SoundtrackTest : public testing::Test {
 public:
  SoundtrackTest(const SoundtrackTest&) = delete;
  SoundtrackTest& operator=(const SoundtrackTest&) = delete;
  SoundtrackTest(SoundtrackTest&&) = delete;
  SoundtrackTest& operator=(SoundtrackTest&&) = delete;

 protected:
  SoundtrackTest() {
    scene.audio.rate = 44100;
    scene.radiation.model = scene::RadiationModel::rayleigh;
    write("sine.tt", "(parameter f 1000) (sine f)");
  }
  ~SoundtrackTest() override { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name) << text;
  }

  void listen_at(const Vector3& position) {
    scene::Listener listener;
    listener.name = "ear";
    listener.receivers.push_back({.channel = "ear", .position = position});
    scene.listeners.push_back(listener);
  }

  /// What the only listener hears of a sine of 1 kHz on a path.
  [[nodiscard]] std::vector<double> heard(const Soundtrack::Path& path, double duration) const {
    Soundtrack track(scene, 1);
    track.start_sound(track.instantiate_sound(track.timbre_tree(folder / "sine.tt"), 1.0, path), 0.0, {});
    return track.render(duration, {}).front().samples;
  }

  /// The scene's samples by its text.
  [[nodiscard]] std::vector<double> sound_of_scene(const std::string& text) const {
    write("scene.yaml", text);
    const timbre::SonicScene sonic = timbre::read_sonic_scene(folder / "scene.yaml", {});
    Soundtrack track(sonic.scene, sonic.seed);
    add_sounds(track, sonic, MotionChannels({}));
    return track.render(sonic.duration, sonic.reverberation).front().samples;
  }

  [[nodiscard]] std::string mistakes_of_scene(const std::string& text) const {
    try {
      static_cast<void>(sound_of_scene(text));
    } catch (const deck::DeckError& error) {
      return std::string(error.what()).substr(folder.string().size() + 1);
    }
    return "";
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("idiophone_" + std::to_string(getpid()) + "_scene");
  scene::Scene scene;
};

ON_RANKS(1);

TEST_F(SoundtrackTest, SoundsFallWithTheDistanceAndArriveLater) {
  listen_at({3.43, 0, 0});
  const auto sound = heard([](double /*time*/) -> Vector3 { return {0, 0, 0}; }, 0.2);
  EXPECT_NEAR(amplitude(sound, 1000, 2205, 4410), 1.0 / 3.43, 1e-3);
  for (std::size_t i = 1000; i < sound.size(); ++i) {  // 0.01 s later
    ASSERT_NEAR(sound[i], std::sin(2.0 * pi * 1000.0 * (static_cast<double>(i) / 44100.0 - 0.01)) / 3.43, 1e-3);
  }
  EXPECT_NEAR(sound[400], 0.0, 1e-6);
}

TEST_F(SoundtrackTest, ApproachRaisesThePitchByDopplersFactor) {
  listen_at({0, 0, 0});
  const auto sound = heard([](double time) -> Vector3 { return {100.0 - 34.3 * time, 0, 0}; }, 1.0);
  const double pitch = 1000.0 / (1.0 - 0.1);
  EXPECT_GT(amplitude(sound, pitch, 30000, 34410), 0.95 * amplitude(sound, pitch, 30000, 30441));
  EXPECT_LT(amplitude(sound, 1000.0, 30000, 34410), 0.1 * amplitude(sound, pitch, 30000, 34410));
}

TEST_F(SoundtrackTest, TheFloorReflects) {
  listen_at({4, 0, 3});
  const Soundtrack::Path path = [](double /*time*/) -> Vector3 { return {0, 0, 0}; };
  const auto free = heard(path, 0.1);
  scene.radiation.floor = scene::Floor{};  // the source is on it
  const auto doubled = heard(path, 0.1);
  for (std::size_t i = 0; i < free.size(); ++i) {
    ASSERT_NEAR(doubled[i], 2.0 * free[i], 1e-9);
  }
}

TEST_F(SoundtrackTest, HeadsHearASoundOnItsSide) {
  const auto sound = sound_of_scene(
      "name: s\nduration: 0.2\nclasses: {sine: sine.tt}\nsounds: {a: {class: sine, at: [-1, 0, 0], parameters: {f: "
      "4000}}}\n"
      "listeners: {head: {type: binaural, position: [0, 0, 0], look: [0, 1, 0], up: [0, 0, 1]}}\n");
  std::array<std::vector<double>, 2> ears;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    ears[i % 2].push_back(sound[i]);
  }
  EXPECT_GT(amplitude(ears[0], 4000, 4410, 8820), 2.0 * amplitude(ears[1], 4000, 4410, 8820));
}

TEST_F(SoundtrackTest, SoundsStartAndStop) {
  Soundtrack track(scene, 1);
  const SoundHandle sound = track.instantiate_sound(track.timbre_tree(folder / "sine.tt"), 2.0);
  track.start_sound(sound, 0.1, {});
  track.stop_sound(sound, 0.2);
  const auto samples = track.render(0.3, {}).front().samples;
  EXPECT_EQ(samples[4410 - 1], 0.0);
  EXPECT_NEAR(samples[4410 + 11], 2.0 * std::sin(2.0 * pi * 1000.0 * 11 / 44100.0), 1e-9);
  EXPECT_NE(samples[8819], 0.0);
  EXPECT_EQ(samples[8820], 0.0);
  EXPECT_EQ(track.starts(), 1U);
  EXPECT_EQ(track.starts_from(0.1), 1U);
  EXPECT_EQ(track.starts_from(0.11), 0U);
}

TEST_F(SoundtrackTest, ScenesBindParameters) {
  const auto sound = sound_of_scene(
      "name: s\nduration: 1\nclasses: {sine: sine.tt}\nvariables: {rise: {keys: [[0, 500], [1, 500]]}}\n"
      "sounds: {a: {class: sine, start: [0, 0.5], duration: 0.25, parameters: {f: rise}}}");
  EXPECT_NEAR(amplitude(sound, 500, 0, 8820), 1.0, 1e-3);
  EXPECT_EQ(sound[12000], 0.0);
  EXPECT_NEAR(amplitude(sound, 500, 22050, 30870), 1.0, 1e-3);
}

TEST_F(SoundtrackTest, ScenesAreChecked) {
  const std::string head = "name: s\nduration: 1\nclasses: {sine: sine.tt}\n";
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sin}}"),
            "scene.yaml:4:21: sounds.a.class: must be one of sine, found 'sin' (did you mean 'sine'?)");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, parameters: {ff: 3}}}"),
            "scene.yaml:4:44: sine.tt has no parameter 'ff' (did you mean 'f'?)");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, parameters: {f: rise}}}"),
            "scene.yaml:4:43: sounds.a.parameters.f: there is no variable 'rise'");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, parameters: {f: {channel: motion/a/velocity}}}}"),
            "scene.yaml:4:53: this needs the motion of a run; give its result NAME.h5 after the scene");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, parameters: {f: {event: force}}}}"),
            "scene.yaml:4:13: sounds.a: a parameter is bound to an event; give the contact that starts the sound");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, at: [0, 0, 0], body: b}}"),
            "scene.yaml:4:13: sounds.a: a sound has one place; give one of at, path and body");
}

TEST_F(SoundtrackTest, ScenesHaveObjectsAndDirectivities) {
  const std::string head =
      "name: s\nduration: 0.3\nclasses: {sine: sine.tt}\nlisteners: {ear: {type: mono, position: [4, 0, 0]}}\n";
  const auto level = [&](const std::string& rest) {
    return 4.0 * amplitude(sound_of_scene(head + rest), 1000, 4410, 13230);
  };
  EXPECT_NEAR(level("sounds: {a: {class: sine, at: [0, 0, 0], directivity: {pattern: cardioid, axis: [0, 2, 0]}}}"),
              0.5, 1e-3);
  EXPECT_NEAR(
      level("sounds: {a: {class: sine, at: [0, 0, 0], directivity: {pattern: [[0, 0], [90, -20]], axis: [0, 0, 1]}}}"),
      0.1, 1e-3);
  const std::string sound = "sounds: {a: {class: sine, at: [0, 0, 0]}}\n";
  EXPECT_NEAR(level(sound + "objects: {wall: {size: [0.1, 3, 3], at: [2, 0, 0]}}"), 0.0, 1e-6);
  EXPECT_NEAR(level(sound + "objects: {wall: {size: [0.1, 3, 3], at: [2, 0, 0], surface_density: 0}}"), 1.0, 1e-3);
  const std::string turned = "objects: {wall: {size: [3, 0.1, 3], at: [2, 1, 0], rotation: {axis: [0, 0, 1], degrees: ";
  EXPECT_NEAR(level(sound + turned + "90}}}"), 0.0, 1e-6);  // now it is across the way
}

TEST_F(SoundtrackTest, ScenesHaveObjectsFromMeshFilesAndDirectivitiesByBand) {
  const std::string head =
      "name: s\nduration: 0.3\nclasses: {sine: sine.tt}\nlisteners: {ear: {type: mono, position: [4, 0, 0]}}\n";
  const auto level = [&](const std::string& rest) {
    return 4.0 * amplitude(sound_of_scene(head + rest), 1000, 4410, 13230);
  };
  write("block.obj",
        "v 0 -1 -1\nv 0.5 -1 -1\nv 0.5 1 -1\nv 0 1 -1\nv 0 -1 1\nv 0.5 -1 1\nv 0.5 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const std::string sound = "sounds: {a: {class: sine, at: [0, 0, 0]}}\n";
  EXPECT_NEAR(level(sound + "objects: {block: {mesh: block.obj, at: [2, 0, 0]}}"), 0.0, 1e-6);
  EXPECT_NEAR(level(sound + "objects: {block: {mesh: block.obj, at: [2, 0, 0], surface_density: 0}}"), 1.0, 1e-3);
  EXPECT_NEAR(level(sound + "objects: {block: {mesh: block.obj, at: [2, 1.5, 0], absorption: 1}}"), 1.0, 1e-3);
  EXPECT_NEAR(level("sounds: {a: {class: sine, at: [0, 0, 0], directivity: {axis: [0, 2, 0], bands: [omni, 0.3, omni, "
                    "cardioid, [[0, 0], [90, -6]], omni]}}}"),
              0.5, 0.02);
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, at: [0, 0, 0], directivity: {axis: [0, 2, 0], bands: "
                                     "[omni]}}}"),
            "scene.yaml:5:80: sounds.a.directivity.bands: needs 6 patterns, for the octaves from 125 Hz on, found 1");
  EXPECT_THAT(mistakes_of_scene(head + sound + "objects: {block: {mesh: block.obj, size: [1, 1, 1], at: [2, 0, 0]}}"),
              testing::HasSubstr("objects.block.size: belongs to a box, which has no mesh"));
  EXPECT_THAT(mistakes_of_scene(head + sound + "objects: {block: {mesh: none.obj, at: [2, 0, 0]}}"),
              testing::HasSubstr("objects.block.mesh: no such file"));
}

TEST_F(SoundtrackTest, ObjectsAndAxesMoveAndTurnWithTheirBody) {  // 1 m up, and a quarter turn about z
  const std::vector<spectra::Series> channels = {{"/motion/ball/centre_of_mass", "m", 2.0, {"x", "y", "z"}, "", {}},
                                                 {"/motion/ball/orientation", "1", 2.0, {"w", "x", "y", "z"}, "", {}}};
  const double half = std::sqrt(0.5);
  const MotionRows rows = {{"/motion/ball/centre_of_mass", {0, 0, 1}},
                           {"/motion/ball/orientation", {half, 0, 0, half}}};
  const auto level = [&](const std::string& rest) {
    write("scene.yaml",
          "name: s\nduration: 0.3\nclasses: {sine: sine.tt}\nlisteners: {ear: {type: mono, position: [4, 0, 1]}}\n" +
              rest);
    const SonicScene sonic = read_sonic_scene(folder / "scene.yaml", {});
    Soundtrack track(sonic.scene, sonic.seed);
    add_sounds(track, sonic, MotionChannels(channels, rows));
    return 4.0 * amplitude(track.render(sonic.duration, {}).front().samples, 1000, 4410, 13230);
  };
  const std::string aimed = "sounds: {a: {class: sine, body: ball, directivity: {pattern: cardioid, axis: ";
  EXPECT_NEAR(level(aimed + "[0, -1, 0]}}}"), 1.0, 1e-3);
  EXPECT_NEAR(level(aimed + "[1, 0, 0]}}}"), 0.5, 1e-3);
  const std::string plate = "objects: {plate: {size: [3, 0.2, 1], body: ball}}\n";  // across the ways along x
  EXPECT_NEAR(level(plate + "sounds: {a: {class: sine, body: ball}}"), 1.0, 1e-3);
  EXPECT_NEAR(level(plate + "sounds: {a: {class: sine, at: [-1, 1, 1]}}"), 0.0, 1e-6);
  EXPECT_NEAR(level(plate + "sounds: {a: {class: sine, at: [0, 3, 1]}}"), 0.8, 1e-3);  // beside it
}

TEST_F(SoundtrackTest, ObjectsAndDirectivitiesAreChecked) {
  const std::string head = "name: s\nduration: 1\nclasses: {sine: sine.tt}\n";
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine, directivity: {pattern: omni, axis: [0, 0, 1]}}}"),
            "scene.yaml:4:40: sounds.a.directivity: has no meaning without a place; give at, path or body");
  EXPECT_EQ(
      mistakes_of_scene(head + "sounds: {a: {class: sine, at: [0, 0, 0], directivity: {pattern: [[90, 0], [0, "
                               "0]], axis: [0, 0, 1]}}}"),
      "scene.yaml:4:65: sounds.a.directivity.pattern: needs rows of angle and level: angles from 0 to 180 degrees, "
      "ascending, and levels up to 100 dB");
  EXPECT_EQ(mistakes_of_scene(head + "sounds: {a: {class: sine}}\nobjects: {wall: {size: [1, 1, 1]}}"),
            "scene.yaml:5:10: objects: stand between sounds and listeners; give listeners\n" +
                (folder / "scene.yaml").string() +
                ":5:17: objects.wall: an object needs a place; give at, path or body");
}

TEST_F(SoundtrackTest, StartsOfOneSoundAddUp) {
  const auto render = [&](const std::vector<double>& starts, double gain) {
    Soundtrack track(scene, 1);
    const SoundHandle sound = track.instantiate_sound(track.timbre_tree(folder / "sine.tt"), gain);
    for (const double time : starts) {
      track.start_sound(sound, time, {});
    }
    return track.render(0.2, {}).front().samples;
  };
  const auto both = render({0.0, 0.05}, 0.5), first = render({0.0}, 0.5), second = render({0.05}, 0.5);
  for (std::size_t i = 0; i < both.size(); ++i) {
    ASSERT_EQ(both[i], first[i] + second[i]) << i;
  }
  EXPECT_NE(first[100], 0.0);
  EXPECT_NE(second[3000], 0.0);
}

TEST_F(SoundtrackTest, ReverberationIsAddedToTheSound) {
  const auto render = [&](const std::optional<Reverberation>& reverberation) {
    Soundtrack track(scene, 1);
    track.start_sound(track.instantiate_sound(track.timbre_tree(folder / "sine.tt")), 0.0, {}, 0.05);
    return track.render(0.2, reverberation).front().samples;
  };
  const auto dry = render({}), wet = render(Reverberation{.decay = 0.4, .level = 0.25});
  DiffuseField room({{}}, 0.4, 343.0, 44100);
  for (std::size_t i = 0; i < dry.size(); ++i) {
    double late = 0.0;
    room.step(dry[i], {&late, 1});
    ASSERT_NEAR(wet[i], dry[i] + 0.25 * late, 1e-15) << i;  // the compiler may fuse the product and the sum
  }
  EXPECT_NE(wet.back(), 0.0);
}

TEST_F(SoundtrackTest, EachStartHasNoiseOfItsOwnAndEachSeedToo) {
  write("noise.tt", "white");
  const auto render = [&](std::uint64_t seed) {
    Soundtrack track(scene, seed);
    const SoundHandle sound = track.instantiate_sound(track.timbre_tree(folder / "noise.tt"));
    track.start_sound(sound, 0.0, {}, 0.05);
    track.start_sound(sound, 0.05, {}, 0.05);
    return track.render(0.1, {}).front().samples;
  };
  const auto sound = render(1);
  EXPECT_EQ(render(1), sound);
  EXPECT_NE(render(2), sound);
  EXPECT_NE(std::vector(sound.begin(), sound.begin() + 2205), std::vector(sound.begin() + 2205, sound.end()));
}

TEST_F(SoundtrackTest, RenderingReportsItsProgress) {
  Soundtrack track(scene, 1);
  track.start_sound(track.instantiate_sound(track.timbre_tree(folder / "sine.tt")), 0.0, {});
  std::vector<std::int64_t> done;
  static_cast<void>(track.render(0.1, {}, [&](std::int64_t samples) { done.push_back(samples); }));
  ASSERT_FALSE(done.empty());
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_EQ(done.back(), 4410);
}

TEST_F(SoundtrackTest, BindingsAreCheckedWhenASoundStarts) {
  Soundtrack track(scene, 1);
  const SoundHandle sound = track.instantiate_sound(track.timbre_tree(folder / "sine.tt"));
  EXPECT_THROW(track.start_sound(sound, 0.0, {{"g", {.value = 1.0, .where = {}}}}), deck::DeckError);
  EXPECT_EQ(track.starts(), 0U);
}

TEST_F(SoundtrackTest, ContactsStartSoundsWithTheirForce) {
  const RecordedMotion recorded;
  write("scene.yaml",
        "name: s\nduration: 1\nclasses: {sine: sine.tt}\nsounds:\n  a: {class: sine, contact: {name: knock, above: "
        "2}, duration: 0.2, parameters: {f: {event: force, scale: 100, offset: 200}}}\n");
  const SonicScene sonic = read_sonic_scene(folder / "scene.yaml", {});
  Soundtrack track(sonic.scene, sonic.seed);
  add_sounds(track, sonic, MotionChannels(recorded.path()));
  EXPECT_EQ(track.starts(), 2U);
  const auto sound = track.render(1.0, {}).front().samples;
  EXPECT_NEAR(amplitude(sound, 500, 4410, 13230), 1.0, 1e-3);    // 3 N at 0.1 s
  EXPECT_NEAR(amplitude(sound, 1000, 22050, 30870), 1.0, 1e-3);  // 8 N at 0.5 s
  EXPECT_EQ(sound[4409], 0.0);
}

TEST_F(SoundtrackTest, SoundsThatHaveDecayedCostNothing) {
  write("knock.tt", "(* (damp 800 0.02) (sine 800))");  // inaudible after 0.21 s
  Soundtrack track(scene, 1);
  const SoundHandle sound = track.instantiate_sound(track.timbre_tree(folder / "knock.tt"));
  for (int knock = 0; knock < 20; ++knock) {
    track.start_sound(sound, 0.1 * knock, {});
  }
  TrackRenderer renderer(track, {}, 2 * 44100);
  const auto whole = renderer.render({}).front().samples;
  EXPECT_LT(renderer.rendered(), 20 * 0.26 * 44100);  // not 20 s
  EXPECT_NE(whole.back(), 0.0);
}

TEST_F(SoundtrackTest, AllMistakesOfASceneAreSaid) {
  write("wrong.tt", "(+ foo (sine))");
  write("broken.tt", "(sine 3");
  EXPECT_EQ(mistakes_of_scene("name: s\nduration: 1\nclasses: {sine: sine.tt, wrong: wrong.tt, broken: broken.tt}\n"
                              "sounds:\n  a: {class: wrong}\n  b: {class: wrong}\n  c: {class: broken}\n"
                              "  d: {class: sine, parameters: {g: 3}}\n"),
            "broken.tt:1:1: this ( is not closed\n" + (folder / "wrong.tt").string() + ":1:4: there is no 'foo'\n" +
                (folder / "wrong.tt").string() + ":1:8: found 0 arguments; write (sine frequency [phase = 0])\n" +
                (folder / "scene.yaml").string() + ":8:36: sine.tt has no parameter 'g'");
}

TEST(Mappings, ScaleBendAndClip) {
  const timbre::Mapping mapping{.scale = 2.0, .offset = 1.0, .curve = 2.0, .range = {{-5.0, 10.0}}};
  EXPECT_EQ(mapping(1.5), 5.5);
  EXPECT_EQ(mapping(-1.0), -1.0);
  EXPECT_EQ(mapping(100.0), 10.0);
}

}  // namespace

}  // namespace idiophone::timbre

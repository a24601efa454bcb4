// The sections with nothing but settings: time, radiation, output, references.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "idiophone/scene/limits.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, AirProperties& air) {
  constexpr double zero_celsius = 273.15;        // K
  constexpr double gas_constant = 287.05;        // of dry air, J/(kg K)
  constexpr double speed_at_20_celsius = 343.2;  // m/s, ISO 9613-1
  Section section(node, mistakes);
  section.optional("temperature", air.temperature,
                   Range{.at_least = -50.0, .at_most = 60.0, .unit = "degrees Celsius"});
  section.optional("humidity", air.humidity, Range{.at_least = 0.0, .at_most = 100.0, .unit = "per cent"});
  section.optional("pressure", air.pressure, Range{.at_least = 1.0, .at_most = 2e5, .unit = "Pa"});
  section.optional("absorption", air.absorption, Choices<bool>{{{"true", true}, {"false", false}}});
  if (section.find("temperature") != nullptr || section.find("pressure") != nullptr) {
    const double kelvin = air.temperature + zero_celsius;
    air.density = air.pressure / (gas_constant * kelvin);
    air.speed = speed_at_20_celsius * std::sqrt(kelvin / (20.0 + zero_celsius));
  }
  section.optional("density", air.density, Range{.at_least = 1e-6, .at_most = 1e4, .unit = "kg/m3"});
  section.optional("speed", air.speed, Range{.at_least = 50.0, .at_most = 1e5, .unit = "m/s"});
  return section.finish();
}

static bool read(const Node& node, Mistakes& mistakes, Floor& floor) {
  Section section(node, mistakes);
  section.required("at", floor.at, coordinate);
  section.optional("direction", floor.direction, unit_vector);
  section.optional("reflection", floor.reflection, Range{.at_least = -1.0, .at_most = 1.0});
  return section.finish();
}

struct Checkpoint {};

/// output.checkpoint: {every_minutes, keep}
static bool read(const Node& node, Mistakes& mistakes, Output& output, const Checkpoint& /*rule*/) {
  Section section(node, mistakes);
  section.optional("every_minutes", output.checkpoint_minutes, Range{.at_least = 0.0, .at_most = 1e6, .unit = "min"});
  section.optional("keep", output.checkpoint_keep, Range{.at_least = 1.0, .at_most = 1e6});
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, Time& time) {
  Section section(node, mistakes);
  section.required("duration", time.duration, Range{.above = 0.0, .at_most = 86400.0, .unit = "s"});
  section.optional("steps_per_sample", time.steps_per_sample, Range{.at_least = 1.0, .at_most = most_steps_per_sample});
  section.optional("safety", time.safety, Range{.above = 0.0, .at_most = 1.0});
  section.optional("wall_clock_limit", time.wall_clock_limit, Range{.above = 0.0, .at_most = 1e9, .unit = "s"});
  return section.finish();
}

/// A section, or the word off.
static bool read(const Node& node, Mistakes& mistakes, std::optional<VisibilityUpdates>& visibility,
                 const Audio& audio) {
  if (node.kind == Node::Kind::scalar) {
    bool off = false;
    if (read(node, mistakes, off, Choices<bool>{{{"off", true}}})) {
      visibility.reset();
    }
    return off;
  }
  Section section(node, mistakes);
  section.optional("rate", visibility.emplace().rate,
                   Range{.at_least = 0.01, .at_most = static_cast<double>(audio.rate), .unit = "per second"});
  return section.finish();
}

/// The key room, once the air is read.
static void read_room(Section& section, Radiation& radiation) {
  if (!section.optional("room", radiation.room) || !radiation.room) {
    return;
  }
  const Node& node = *section.find("room");
  check_room(node, section.mistakes(), *radiation.room, radiation.air.speed);
  if (radiation.floor) {
    section.mistakes().add(node, "a room has a floor already; give one of room and floor");
  }
}

/// What is wrong with the polygon of a screen; empty for nothing.
static std::string wrong_polygon(const std::vector<Vector3>& corners) {
  if (corners.size() < 3) {
    return "a screen has at least three corners";
  }
  const auto corner = [&](std::size_t i) -> const Vector3& { return corners[i % corners.size()]; };
  Vector3 area = Vector3::Zero();
  double size = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += 0.5 * (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    size = std::max({size, (corners[i] - corners[0]).norm(), (corners[i + 1] - corners[0]).norm()});
  }
  if (!(area.norm() > 1e-6 * size * size)) {
    return "the screen has no area";
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::abs((corners[i] - corners[0]).dot(area.normalized())) > 1e-6 * size) {
      return "the corners are not in one plane; a screen is flat";
    }
    if (!((corner(i + 1) - corner(i)).cross(corner(i + 2) - corner(i + 1)).dot(area) > 0.0)) {
      return fmt::format("the polygon is not convex at corner {}; make several screens", (i + 1) % corners.size() + 1);
    }
  }
  return "";
}

static bool read(const Node& node, Mistakes& mistakes, Screen& screen) {
  Section section(node, mistakes);
  if (section.required("corners", screen.corners, coordinate)) {
    if (const std::string wrong = wrong_polygon(screen.corners); !wrong.empty()) {
      mistakes.add(*section.find("corners"), wrong);
    }
  }
  return section.finish();
}

/// The key screens, once the others are read.
static void read_screens(Section& section, Radiation& radiation) {
  if (!section.optional("screens", radiation.screens) || radiation.screens.empty()) {
    return;
  }
  const Node& node = *section.find("screens");
  if (!radiation.visibility) {
    section.mistakes().add(node, "screens need visibility, which is off");
  }
}

/// The key diffraction, likewise.
static void read_diffraction(Section& section, Radiation& radiation) {
  if (!section.optional("diffraction", radiation.diffraction, Choices<bool>{{{"true", true}, {"false", false}}}) ||
      !radiation.diffraction) {
    return;
  }
  const Node& node = *section.find("diffraction");
  if (!radiation.visibility) {
    section.mistakes().add(node, "diffraction needs visibility, which is off");
  }
}

/// The keys of model waves, and what it needs of the floor.
static void read_wave_grid(Section& section, Radiation& radiation) {
  section.required("cell", radiation.grid.cell, Range{.at_least = 1e-4, .at_most = 1.0, .unit = "m"});
  section.optional("margin", radiation.grid.margin, Range{.at_least = 0.0, .at_most = 100.0, .unit = "m"});
  section.optional("back", radiation.grid.back, Choices<bool>{{{"true", true}, {"false", false}}});
  section.optional("wall_losses", radiation.grid.wall_losses, Choices<bool>{{{"true", true}, {"false", false}}});
  if (radiation.floor && (radiation.floor->direction[2] < 1.0 - 1e-9 || radiation.floor->reflection != 1.0)) {
    section.mistakes().add(
        *section.find("floor"),
        "model waves has only floors with direction [0, 0, 1] and reflection 1; an obstacle of shape "
        "box can be a tilted wall, and the models kirchhoff and rayleigh have floors that absorb");
  }
}

bool read(const Node& node, Mistakes& mistakes, Radiation& radiation, const Audio& audio) {
  const Choices<RadiationModel> models{{{"huygens", RadiationModel::huygens},
                                        {"rayleigh", RadiationModel::rayleigh},
                                        {"kirchhoff", RadiationModel::kirchhoff},
                                        {"waves", RadiationModel::waves}}};
  const Choices<SurfacePressureModel> fields{{{"plane_wave", SurfacePressureModel::plane_wave},
                                              {"pulsating", SurfacePressureModel::pulsating},
                                              {"oscillating", SurfacePressureModel::oscillating}}};
  Section section(node, mistakes);
  const bool model_known = section.optional("model", radiation.model, models);
  if (model_known && radiation.model != RadiationModel::kirchhoff) {
    section.refuse("surface_pressure", "only model kirchhoff uses it");
  } else {
    section.optional("surface_pressure", radiation.surface_pressure, fields);
  }
  section.optional("air", radiation.air);
  section.optional("floor", radiation.floor);
  read_room(section, radiation);
  if (radiation.model == RadiationModel::waves) {
    section.refuse("visibility", "waves bend around bodies by themselves");
    section.refuse("diffraction", "waves bend around bodies by themselves");
    section.refuse("screens", "waves bend around bodies by themselves; an obstacle can be a screen");
    read_wave_grid(section, radiation);
  } else {
    section.optional("visibility", radiation.visibility, audio);
    read_screens(section, radiation);
    read_diffraction(section, radiation);
    for (const char* key : {"cell", "margin", "back", "wall_losses"}) {
      section.refuse(key, "only model waves uses it");
    }
  }
  return section.finish();
}

void read_wav(Section& section, Output& output) {
  const Choices<WavFormat> formats{
      {{"float32", WavFormat::float32}, {"pcm24", WavFormat::pcm24}, {"pcm16", WavFormat::pcm16}}};
  section.optional("wav", output.wav, formats);
  section.optional("wav_full_scale", output.wav_full_scale, Range{.at_least = 1e-20, .at_most = 1e12, .unit = "Pa"});
}

bool read(const Node& node, Mistakes& mistakes, Output& output, const Audio& audio) {
  const Range up_to_rate{.at_least = 0.0, .at_most = static_cast<double>(audio.rate), .unit = "per second"};
  Section section(node, mistakes);
  section.optional("frames_per_second", output.frames_per_second, up_to_rate);
  section.optional("motion_per_second", output.motion_per_second, up_to_rate);
  read_wav(section, output);
  section.optional("surface_motion", output.surface_motion, Choices<bool>{{{"true", true}, {"false", false}}});
  section.optional("checkpoint", output, Checkpoint{});
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, std::vector<ReferenceSet>& references) {
  if (node.kind != Node::Kind::map) {
    return mistakes.add(node, "expected a map {NAME: [frequencies in Hz]}, found " + describe(node));
  }
  bool good = true;
  for (const Node& child : node.children) {
    ReferenceSet reference{.name = child.key, .frequencies = {}};
    if (child.kind != Node::Kind::list || child.children.empty()) {
      good = mistakes.add(child, "expected a list of frequencies (Hz), found " + describe(child));
    }
    for (const Node& item : child.children) {
      good &=
          read(item, mistakes, reference.frequencies.emplace_back(), Range{.above = 0.0, .at_most = 1e9, .unit = "Hz"});
    }
    references.push_back(reference);
  }
  return good;
}

}  // namespace idiophone::scene

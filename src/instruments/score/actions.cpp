// What is done to bodies, as events and notes of a score have it.

#include "actions.hpp"

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

constexpr Range hertz_hardness{.at_least = 1.0, .at_most = 1e15, .unit = "N/m^(3/2)"};
constexpr Range hammer_speed{.at_least = 1e-6, .at_most = 1e3, .unit = "m/s"};
constexpr Range small_length{.at_least = 1e-9, .at_most = 10.0, .unit = "m"};
constexpr double longest_contact = 1.0;        // s, of a blow
constexpr double most_waves_of_profile = 1e7;  // in a stroke

/// roughness: {height, exponent, longest, shortest}
struct RoughnessKeys {};

bool read(const Node& node, Mistakes& mistakes, Roughness& roughness, const RoughnessKeys& /*rule*/) {
  Section section(node, mistakes);
  section.required("height", roughness.height, Range{.at_least = 0.0, .at_most = 1.0, .unit = "m"});
  section.optional("exponent", roughness.exponent, Range{.at_least = 0.0, .at_most = 4.0});
  const bool has_longest = section.optional("longest", roughness.longest, small_length);
  if (section.optional("shortest", roughness.shortest, small_length) && has_longest &&
      roughness.shortest >= roughness.longest) {
    mistakes.add(node, fmt::format("the shortest wavelength, {} m, must be below the longest, {} m", roughness.shortest,
                                   roughness.longest));
  }
  return section.finish();
}

void check_stroke(Section& section, const Stroke& stroke) {
  const double distance = (stroke.to - stroke.from).norm();
  if (distance <= 0.0) {
    section.mistakes().add(section.node(), "from and to are the same point; the contact must move");
  } else if (distance / stroke.speed > longest_force) {
    section.mistakes().add(
        section.node(), fmt::format("takes {:.4g} s; a stroke can take {} s", distance / stroke.speed, longest_force));
  } else if (distance / stroke.roughness.shortest > most_waves_of_profile) {
    section.mistakes().add(section.node(), fmt::format("has {:.4g} of the shortest waves of its roughness; {} are "
                                                       "possible. Raise roughness.shortest",
                                                       distance / stroke.roughness.shortest, most_waves_of_profile));
  }
}

template <class Value>
void read_if_given(Section& section, const std::string& key, std::optional<Value>& value, const Range& range) {
  if (section.find(key) != nullptr) {
    section.required(key, value.emplace(), range);
  }
}

}  // namespace

void read_body(Section& section, std::size_t& body, const BodyNames& bodies) {
  if (bodies.words.size() > 1) {
    section.required("body", body, bodies);
  } else {
    section.optional("body", body, bodies);
  }
}

void read_hammer_blow(Section& section, HammerBlow& blow) {
  section.required("at", blow.at, scene::coordinate);
  section.required("direction", blow.direction, scene::unit_vector);
  const bool has_mass = section.required("mass", blow.hammer.mass, hammer_mass);
  const bool has_hardness = section.required("hardness", blow.hammer.hardness, hertz_hardness);
  if (section.required("speed", blow.hammer.speed, hammer_speed) && has_mass && has_hardness &&
      blow.hammer.contact_duration() > longest_contact) {
    section.mistakes().add(section.node(), fmt::format("touches for {:.4g} s; a blow can take {} s. Raise the hardness",
                                                       blow.hammer.contact_duration(), longest_contact));
  }
}

void read_mallet_blow(Section& section, MalletBlow& mallet) {
  read_hammer_blow(section, mallet.blow);
  section.optional("loss", mallet.loss, contact_loss);
}

void read_applied_force(Section& section, AppliedForce& applied, const Folder& folder, When when) {
  section.required("at", applied.at, scene::coordinate);
  section.required("force", applied.force, scene::force_component);
  if (when == When::at_once && section.find("table") != nullptr) {
    for (const char* key : {"shape", "start", "duration", "frequency"}) {
      section.know(key);
    }
    section.refuse("table", "an event that is sent can't name files");
    return;
  }
  if (scene::read_signal(section, folder, applied.signal) && !(applied.end() <= longest_force)) {
    section.mistakes().add(
        section.node(), fmt::format("ends after {} s; a force has to end within {} s", applied.end(), longest_force));
  }
}

void read_stroke(Section& section, Stroke& stroke) {
  const std::size_t before = section.mistakes().count();
  section.required("from", stroke.from, scene::coordinate);
  section.required("to", stroke.to, scene::coordinate);
  section.required("direction", stroke.direction, scene::unit_vector);
  section.required("speed", stroke.speed, hammer_speed);
  section.required("load", stroke.load, Range{.above = 0.0, .at_most = 1e6, .unit = "N"});
  section.required("mass", stroke.mass, hammer_mass);
  section.required("hardness", stroke.hardness, hertz_hardness);
  section.optional("size", stroke.size, Range{.at_least = 0.0, .at_most = 1.0, .unit = "m"});
  if (stroke.kind == Stroke::Kind::scrape) {
    section.optional("friction", stroke.friction, Range{.at_least = 0.0, .at_most = 10.0});
  } else {
    section.refuse("friction", "a body that rolls does not slide; leave it out");
  }
  section.required("roughness", stroke.roughness, RoughnessKeys{});
  if (section.mistakes().count() == before) {
    check_stroke(section, stroke);
  }
}

void read_tuning(Section& section, Tuning& tuning) {
  section.optional("size", tuning.size, Range{.at_least = 0.01, .at_most = 100.0});
  section.optional("friction", tuning.friction, Range{.at_least = 0.0, .at_most = 1e6});
  section.optional("tension", tuning.tension, Range{.at_least = 1e-4, .at_most = 1e4});
}

void read_detail(Section& section, Detail& detail) {
  read_if_given(section, "level", detail.level, Range{.at_least = -1.0, .at_most = 5.0});
  read_if_given(section, "priority", detail.priority, Range{.at_least = -1e9, .at_most = 1e9});
  read_if_given(section, "budget", detail.budget, Range{.at_least = 1e-6, .at_most = 1e6});
  read_if_given(section, "most_active", detail.most_active, Range{.at_least = 1.0, .at_most = 1e6});
  if (!detail.level && !detail.priority && !detail.budget && !detail.most_active) {
    section.mistakes().add(section.node(), "changes nothing; give level, priority, budget or most_active");
  }
}

double AppliedForce::end() const {
  return signal.end();
}

}  // namespace idiophone::score

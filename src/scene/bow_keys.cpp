#include "idiophone/scene/bow_keys.hpp"

#include "friction_keys.hpp"
#include "idiophone/scene/course_keys.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

struct LawKeys {};

bool read(const Node& node, Mistakes& mistakes, friction::Law& law, const LawKeys& /*rule*/) {
  Section section(node, mistakes);
  read_law(section, law);
  return section.finish();
}

}  // namespace

void read_bowing(Section& section, Bowing& bowing, double longest) {
  section.required("direction", bowing.direction, unit_vector);
  section.required("speed", bowing.speed, CourseRule{{.at_least = -1e3, .at_most = 1e3, .unit = "m/s"}, longest});
  section.required("load", bowing.load, CourseRule{{.at_least = 0.0, .at_most = 1e6, .unit = "N"}, longest});
  section.optional("friction", bowing.friction, LawKeys{});
}

}  // namespace idiophone::scene

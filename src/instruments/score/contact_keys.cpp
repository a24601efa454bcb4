#include "contact_keys.hpp"

#include <cmath>

#include "idiophone/scene/course_keys.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

/// A surface near the point where it touches another.
struct Surface {
  scene::Material material;
  double curvature = 0.0;  // mean of both directions, 1/m; negative: hollow
};

/// Those that have the same stiffness in all directions.
std::vector<scene::Material> isotropic_materials() {
  std::vector<scene::Material> materials;
  scene::add_shipped(materials);
  std::erase_if(materials, [](const scene::Material& material) { return !material.is_isotropic(); });
  return materials;
}

void read_material(Section& section, scene::Material& material) {
  section.know("material");
  if (section.find("material") == nullptr) {
    section.required("young", material.young, Range{.at_least = 1.0, .at_most = 1e15, .unit = "Pa"});
    section.required("poisson", material.poisson, Range{.at_least = -0.9999, .at_most = 0.4999});
    return;
  }
  const std::vector<scene::Material> materials = isotropic_materials();
  Choices<std::size_t> names;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    names.words.emplace_back(materials[i].name, i);
  }
  std::size_t chosen = 0;
  if (section.required("material", chosen, names)) {
    material = materials[chosen];
  }
}

bool read(const Node& node, Mistakes& mistakes, Surface& surface) {
  Section section(node, mistakes);
  read_material(section, surface.material);
  if (section.find("radius") != nullptr) {
    double radius = 0.0;
    if (section.required("radius", radius, Range{.at_least = -1e3, .at_most = 1e3, .unit = "m"})) {
      surface.curvature = 1.0 / radius;
    }
  }
  return section.finish();
}

/// Hertz' hardness, 4/3 E* sqrt(R) with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 and 1/R = 1/R1 + 1/R2 (K. L. Johnson,
/// Contact Mechanics, 1985, section 4.2).
void read_surfaces(Section& section, double& hardness) {
  std::vector<Surface> surfaces;
  if (!section.required("surfaces", surfaces)) {
    return;
  }
  const Node& node = *section.find("surfaces");
  if (surfaces.size() != 2) {
    section.mistakes().add(node, fmt::format("two surfaces touch each other, not {}", surfaces.size()));
    return;
  }
  double compliance = 0.0, curvature = 0.0;
  for (const Surface& surface : surfaces) {
    compliance += (1.0 - surface.material.poisson * surface.material.poisson) / surface.material.young;
    curvature += surface.curvature;
  }
  if (!(curvature >= 1e-3 && curvature <= 1e9)) {
    section.mistakes().add(node,
                           "the surfaces must touch at a point: the sum of 1/radius, where a flat one has no "
                           "radius and a hollow one a negative radius, must be from 0.001 to 1e9 1/m");
    return;
  }
  hardness = 4.0 / 3.0 / compliance / std::sqrt(curvature);
}

void read_elasticity(Section& section, Elasticity& elasticity) {
  section.optional("loss", elasticity.loss, contact_loss);
  if (section.find("surfaces") != nullptr) {
    section.refuse("hardness", "it follows from the surfaces; leave one of them out");
    section.refuse("exponent", "round surfaces have the exponent 1.5; leave it out, or give the hardness");
    read_surfaces(section, elasticity.hardness);
    return;
  }
  section.required("hardness", elasticity.hardness, Range{.at_least = 1.0, .at_most = 1e15, .unit = "N/m^exponent"});
  section.optional("exponent", elasticity.exponent, Range{.at_least = 1.0, .at_most = 4.0});
}

/// other: {body, at}
struct PointKeys {
  const BodyNames& bodies;
};

bool read(const Node& node, Mistakes& mistakes, PointOfBody& point, const PointKeys& rule) {
  Section section(node, mistakes);
  read_body(section, point.body, rule.bodies);
  section.required("at", point.at, scene::coordinate);
  return section.finish();
}

/// The keys mass and load.
void read_mass(Section& section, BodyContact& contact) {
  if (section.find("mass") == nullptr) {
    section.refuse("load", "only a loose mass has a load; give its mass, too");
    return;
  }
  LooseMass& mass = contact.mass.emplace();
  section.required("mass", mass.mass, hammer_mass);
  section.required("load", mass.load, Range{.above = 0.0, .at_most = 1e6, .unit = "N"});
  if (contact.other) {
    section.mistakes().add(section.node(), "a body touches another one or a loose mass; leave out `other` or `mass`");
  }
  if (contact.gap.points.size() > 1 || contact.gap.largest() < 0.0) {
    section.mistakes().add(section.node(),
                           "the gap of a loose mass is the height from which it falls at first, one "
                           "number that is not negative");
  }
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, BodyContact& contact, const ContactRule& rule) {
  constexpr double longest_course = 86400.0;  // s
  Section section(node, mistakes);
  read_body(section, contact.point.body, rule.bodies);
  section.required("at", contact.point.at, scene::coordinate);
  section.required("direction", contact.direction, scene::unit_vector);
  if (section.find("other") != nullptr) {
    section.required("other", contact.other.emplace(), PointKeys{rule.bodies});
  }
  read_elasticity(section, contact.elasticity);
  const scene::CourseRule gap{.range = {.at_least = -0.1, .at_most = 10.0, .unit = "m"}, .longest = longest_course};
  if (section.required("gap", contact.gap, gap)) {
    read_mass(section, contact);
  }
  for (const char* key : {"mass", "load"}) {
    section.know(key);
  }
  return section.finish();
}

}  // namespace idiophone::score

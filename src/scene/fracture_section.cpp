// Surfaces along which a body breaks.

#include <set>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// {surface, strength, shear_strength, energy, contact}
static bool read(const Node& node, Mistakes& mistakes, FractureSurface& fracture) {
  fracture.where = node.where;
  Section section(node, mistakes);
  section.required("surface", fracture.group);
  section.required("strength", fracture.strength, Range{.above = 0.0, .at_most = 1e15, .unit = "Pa"});
  section.optional("shear_strength", fracture.shear_strength, Range{.above = 0.0, .at_most = 1e15, .unit = "Pa"});
  section.optional("energy", fracture.energy, Range{.at_least = 0.0, .at_most = 1e9, .unit = "J/m2"});
  section.optional("contact", fracture.contact, Choices<bool>{{{"true", true}, {"false", false}}});
  return section.finish();
}

namespace {

/// Two strengths of one surface contradict each other.
void refuse_repeated_surfaces(const Body& body, Mistakes& mistakes) {
  std::set<std::string> named;
  for (const FractureSurface& fracture : body.fracture) {
    if (!named.insert(fracture.group).second) {
      mistakes.add(fracture.where,
                   fmt::format("bodies.{}.fracture: the surface '{}' is named twice", body.name, fracture.group));
    }
  }
}

}  // namespace

void read_fracture(Section& section, Body& body) {
  if (section.find("fracture") == nullptr) {
    return;
  }
  if (body.modal) {
    section.refuse("fracture",
                   "has no meaning with a modal body, whose modes are those of the whole body: use model: {type: "
                   "finite_elements}");
  } else if (body.mass_scaling) {
    section.refuse("fracture",
                   "has no meaning with mass_scaling, which ties nodes to each other: leave one of them out");
  } else if (section.optional("fracture", body.fracture)) {
    refuse_repeated_surfaces(body, section.mistakes());
  }
}

void refuse_fracture(std::span<const Body> bodies, const Radiation& radiation, Mistakes& mistakes) {
  for (const Body& body : bodies) {
    if (!body.fracture.empty() && radiation.model == RadiationModel::waves) {
      mistakes.add(body.fracture.front().where,
                   fmt::format("bodies.{}.fracture: the radiation model `waves` does not know surfaces that appear "
                               "during a run: take `kirchhoff`, `rayleigh` or `huygens`",
                               body.name));
    }
  }
}

}  // namespace idiophone::scene

// The keys of bolts.

#include <numbers>

#include "idiophone/scene/ranges.hpp"
#include "joint_keys.hpp"

namespace idiophone::scene {

double Shank::section() const {
  return std::numbers::pi * radius * radius;
}

namespace {

constexpr Range bolt_length{.above = 0.0, .at_most = farthest_coordinate, .unit = "m"};
constexpr double largest_strain = 0.02;  // by the preload, which the stiffness of a shank leaves out of account

void read_layer(Section& section, Joint& joint) {
  PatchPlace& washer = joint.place.emplace();
  section.required("at", washer.at, coordinate);
  section.required("radius", washer.radius, bolt_length);
  read_layer_stiffness(section, joint.stiffness);
  section.optional("reach", joint.reach, bolt_length);
  for (const char* key : {"axis", "material", "preload"}) {
    section.refuse(key, "needs a shank: without one, a bolt is a layer under its washer, which no pull makes stiffer");
  }
}

void read_shank(Section& section, Joint& joint, const std::vector<Material>& materials) {
  Shank& shank = joint.shank.emplace();
  section.required("shank", shank.radius, bolt_length);
  constexpr double shortest = 1e-6;  // m
  if (section.required("axis", joint.axis) && (joint.axis.end - joint.axis.begin).norm() < shortest) {
    section.refuse("axis", fmt::format("is shorter than {:g} m: a shank is a beam between two washers", shortest));
  }
  if (section.required("radius", shank.washer, bolt_length) && shank.washer < shank.radius) {
    section.refuse("radius", "is that of the washers, which must not be smaller than that of the shank");
  }
  const Material* material = read_joint_material(section, joint, materials);
  if (section.optional("preload", shank.preload, Range{.at_least = 0.0, .at_most = 1e12, .unit = "N"}) &&
      material != nullptr && shank.radius > 0) {
    shank.young = material->young;
    shank.poisson = material->poisson;
    const double most = largest_strain * shank.young * shank.section();
    if (shank.preload > most) {
      section.refuse("preload", fmt::format("must be at most {:.4g} N, which stretches the shank by {:g} %: give a "
                                            "smaller pull or a thicker shank",
                                            most, 100 * largest_strain));
    }
  }
  for (const char* key : {"at", "stiffness", "reach"}) {
    section.refuse(key, "has no meaning with shank: the shank goes from one end of its axis to the other one");
  }
}

}  // namespace

void read_bolt(Section& section, Joint& joint, const std::vector<Material>& materials) {
  if (section.find("shank") == nullptr) {
    read_layer(section, joint);
  } else {
    read_shank(section, joint, materials);
  }
}

}  // namespace idiophone::scene

// How a body moves: by its finite elements or by its modes.

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

enum class ModelType { finite_elements, modal };

/// The keys of a model.
struct Model {
  ModelType type = ModelType::finite_elements;
  ModalModel modal;
};

namespace {

constexpr double default_highest_mode = 20000.0;       // Hz
constexpr double default_stretching_tolerance = 1e-2;  // of the energy of stretching

/// What modes alone cannot do.
void check_modal(const Body& body, Mistakes& mistakes, const Location& where) {
  if (!body.driven.empty()) {
    mistakes.add(where, "a modal body cannot have driven groups; use model: {type: finite_elements}");
  }
  if (body.mass_scaling) {
    mistakes.add(where, "a modal body needs no mass_scaling, since its modes do not limit the step; leave it out");
  }
  for (const FixedGroup& fixed : body.fixed) {
    if (fixed.hinge) {
      mistakes.add(fixed.where,
                   "a modal body cannot turn about a hinge: it is held, or it is free; use model: {type: "
                   "finite_elements}");
    }
  }
}

/// large_amplitudes, stretching_tolerance
void read_amplitudes(Section& section, ModalModel& modal) {
  bool large = false;
  section.optional("large_amplitudes", large, Choices<bool>{{{"true", true}, {"false", false}}});
  if (!large) {
    if (section.find("stretching_tolerance") != nullptr) {
      section.refuse("stretching_tolerance", "has no meaning without large_amplitudes: true");
    }
    return;
  }
  double& tolerance = modal.stretching_tolerance.emplace(default_stretching_tolerance);
  section.optional("stretching_tolerance", tolerance, Range{.at_least = 1e-6, .at_most = 0.1});
}

}  // namespace

/// model: {type, up_to or count, large_amplitudes, stretching_tolerance}
static bool read(const Node& node, Mistakes& mistakes, Model& model) {
  static const Choices<ModelType> types = {
      {{"finite_elements", ModelType::finite_elements}, {"modal", ModelType::modal}}};
  Section section(node, mistakes);
  section.optional("type", model.type, types);
  model.modal.where = node.where;
  if (model.type == ModelType::finite_elements) {
    for (const char* key : {"up_to", "count", "large_amplitudes", "stretching_tolerance"}) {
      if (section.find(key) != nullptr) {
        section.refuse(key, "has no meaning with type finite_elements: only modal has it");
      }
    }
    return section.finish();
  }
  section.optional("up_to", model.modal.up_to, Range{.above = 0.0, .at_most = 1e6, .unit = "Hz"});
  section.optional("count", model.modal.count, Range{.at_least = 1, .at_most = 10000});
  if (section.find("up_to") != nullptr) {
    section.refuse("count", "cannot stand beside up_to: give one of them");
  } else if (section.find("count") == nullptr) {
    model.modal.up_to = default_highest_mode;
  }
  read_amplitudes(section, model.modal);
  return section.finish();
}

void read_model(Section& section, Body& body) {
  Model model;
  if (section.optional("model", model) && model.type == ModelType::modal) {
    body.modal = model.modal;
    check_modal(body, section.mistakes(), model.modal.where);
  }
}

}  // namespace idiophone::scene

#include "modal_preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/accuracy/pitch_error.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"

namespace idiophone::bodies {

namespace {

/// Nodes of a body that loads, supports or contacts may act on, ascending, in the mesh's numbers. Not those of joints:
/// what all of them do together is in the body's modes.
std::vector<Index> loaded_nodes(const Preparation& ready, std::size_t body) {
  const motion::Attachments& attachments = ready.attachments;
  std::vector<Index> nodes;
  const auto add = [&](const mesh::Patch& patch) { nodes.insert(nodes.end(), patch.nodes.begin(), patch.nodes.end()); };
  for (std::size_t p = 0; p < attachments.pulses.size(); ++p) {
    if (ready.scene.pulses[p].body == body) {
      add(attachments.pulses[p]);
    }
  }
  for (std::size_t b = 0; b < attachments.bows.size(); ++b) {
    if (ready.scene.bows[b].body == body) {
      add(attachments.bows[b]);
    }
  }
  for (const auto& triangles : attachments.winds) {
    for (const mesh::Triangle& triangle : triangles) {
      std::ranges::copy_if(triangle, std::back_inserter(nodes), [&](Index node) {
        return node >= ready.offsets.nodes[body] && node < ready.offsets.nodes[body + 1];
      });
    }
  }
  std::ranges::for_each(attachments.bodies[body].supports, add);
  const contact::Skin& skin = ready.contact_surfaces.skins[body];
  for (std::size_t node = 0; node < skin.nodes.size(); ++node) {
    if (skin.areas[node] > 0) {
      nodes.push_back(skin.nodes[node]);
    }
  }
  keep_each_once(nodes);
  std::vector<Index> joined;
  for (const joints::MeshedJoint& joint : attachments.joints) {
    std::ranges::transform(joint.weights, std::back_inserter(joined), &joints::NodeWeight::node);
  }
  keep_each_once(joined);
  std::erase_if(nodes, [&](Index node) { return std::ranges::binary_search(joined, node); });
  for (Index& node : nodes) {
    node -= ready.offsets.nodes[body];
  }
  return nodes;
}

/// @throws deck::DeckError where the highest mode's waves have less than two nodes to a length: the mesh does not have
///         them. Whether it has them in tune is what `check` says.
void require_fine_mesh(const Preparation& ready, std::size_t b) {
  const scene::Body& body = ready.scene.bodies[b];
  if (!body.modal->up_to || body.prestress) {  // waves under tension are longer
    return;
  }
  const accuracy::Cells cells = accuracy::cells_of(ready.statistics[b], body.element);
  const int order = element::orders(body.element).plane;
  double wave = std::numeric_limits<double>::infinity();  // m
  for (const scene::MaterialRegion& region : body.all_regions()) {
    wave = std::min(wave,
                    accuracy::bending_wavelength(ready.scene.materials[region.material],
                                                 accuracy::extents(ready.statistics[b]).thickness, *body.modal->up_to));
  }
  if (wave < 2 * cells.size / order) {
    throw deck::DeckError(
        body.modal->where,
        fmt::format("bodies.{}.model.up_to: waves of {:.6g} Hz are {:.3g} m long, and the nodes of the mesh {:.3g} m "
                    "apart. Make the elements smaller, or lower up_to",
                    body.name, *body.modal->up_to, wave, cells.size / order));
  }
}

/// Adds the bases of an assembly whose bodies have common modes.
void add_common_bases(const Preparation& ready, const std::vector<std::size_t>& bodies,
                      const std::vector<mesh::Mesh>& meshes, modal_bodies::ModalBases& bases) {
  std::vector<mesh::Mesh> own;
  std::vector<std::vector<Index>> loaded;
  for (const std::size_t body : bodies) {
    require_fine_mesh(ready, body);
    own.push_back(meshes[body]);
    own.back().beside.reset();  // a number among all meshes
    loaded.push_back(loaded_nodes(ready, body));
  }
  std::vector<modal_bodies::ModalBasis> found = eigenmodes::common_bases(ready.scene, bodies, own, loaded);
  for (std::size_t place = 0; place < bodies.size(); ++place) {
    bases[bodies[place]] = std::move(found[place]);
  }
}

}  // namespace

modal_bodies::ModalBases find_modal_bases(const Preparation& ready, const std::vector<mesh::Mesh>& meshes) {
  modal_bodies::ModalBases bases;
  const auto joined = eigenmodes::joined_motions(ready.scene, meshes);
  for (const std::vector<std::size_t>& bodies : scene::assemblies(ready.scene)) {
    if (scene::has_common_modes(ready.scene, bodies.front())) {
      add_common_bases(ready, bodies, meshes, bases);
    }
  }
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    if (ready.scene.bodies[b].modal && !bases.contains(b)) {
      require_fine_mesh(ready, b);
      const auto motion = joined.find(b);
      bases[b] = eigenmodes::modal_basis(ready.scene, b, meshes[b], loaded_nodes(ready, b),
                                         motion == joined.end() ? nullptr : &motion->second);
    }
  }
  return bases;
}

}  // namespace idiophone::bodies

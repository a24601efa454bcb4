#include "checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "connected_parts.hpp"
#include "element_shape.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/scene/limits.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

namespace {

constexpr double smallest_mesh = 1e-6;      ///< m, along its longest side
constexpr double same_place = 1e-9;         ///< of the mesh's size: nodes nearer than that are in one place
constexpr std::size_t listed_at_most = 10;  ///< culprits named in an error

[[noreturn]] void refuse(const scene::Body& body, const std::string& message) {
  throw deck::DeckError(body.mesh_where, text_of_problem(body, message));
}

void require_none(const scene::Body& body, const std::string& problem) {
  if (!problem.empty()) {
    refuse(body, problem);
  }
}

/// One line for each of the first culprits, and how many more there are.
std::string listed(const std::vector<std::string>& culprits) {
  std::string text;
  for (std::size_t i = 0; i < std::min(culprits.size(), listed_at_most); ++i) {
    text += "\n  " + culprits[i];
  }
  if (culprits.size() > listed_at_most) {
    text += fmt::format("\n  and {} more", culprits.size() - listed_at_most);
  }
  return text;
}

/// Meshes are in metres. What is far from anything that sounds overflows or underflows later.
void check_size(const scene::Body& body, const GmshMesh& loaded) {
  const auto& nodes = loaded.mesh.nodes;
  double size = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    size = std::max(size, (nodes[i] - nodes.front()).lpNorm<Eigen::Infinity>());
    if (!(nodes[i].lpNorm<Eigen::Infinity>() <= scene::farthest_coordinate)) {
      refuse(body, fmt::format("has node {} at {} m; coordinates must be at least -{} and at most {} m. Is the mesh in "
                               "metres?",
                               loaded.node_tags[i], to_text(nodes[i]), scene::farthest_coordinate,
                               scene::farthest_coordinate));
    }
  }
  if (size < smallest_mesh) {
    refuse(body, fmt::format("measures {:.3g} m; it must measure at least {} m. Is the mesh in metres?", size,
                             smallest_mesh));
  }
}

void check_places(const scene::Body& body, const GmshMesh& loaded) {
  const auto& nodes = loaded.mesh.nodes;
  double size = 0.0;
  for (const auto& node : nodes) {
    size = std::max(size, (node - nodes.front()).lpNorm<Eigen::Infinity>());
  }
  const double scale = size > 0.0 ? 1.0 / (same_place * size) : 0.0;
  const auto rounded = [&](Index node) {
    const Vector3 cell = (scale * (nodes[node] - nodes.front())).array().round();
    return std::array{cell.x(), cell.y(), cell.z()};
  };
  std::vector<Index> order(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index node) { return std::pair(rounded(node), node); });
  std::vector<std::string> culprits;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (rounded(order[i - 1]) == rounded(order[i])) {
      const Index first = order[i - 1];
      culprits.push_back(fmt::format("nodes {} and {} at {}", loaded.node_tags[first], loaded.node_tags[order[i]],
                                     to_text(nodes[first])));
    }
  }
  if (!culprits.empty()) {
    refuse(body, fmt::format("has {} pairs of nodes in one place, where it isn't joined (in a .geo file, Coherence or "
                             "BooleanFragments joins volumes):{}",
                             culprits.size(), listed(culprits)));
  }
}

/// What is wrong with the shapes of elements; empty for nothing. Likewise below.
std::string problem_of_shapes(const GmshMesh& loaded) {
  std::vector<std::string> culprits;
  Index inverted = 0;
  for (Index element = 0; element < loaded.mesh.element_count(); ++element) {
    const double quality = quality_of(shape_of(loaded.mesh, element));
    if (!(quality >= flat_quality)) {
      inverted += quality < -flat_quality ? 1 : 0;
      culprits.push_back(fmt::format("{}, quality {:.3g}", element_text(loaded, element), quality));
    }
  }
  if (culprits.empty()) {
    return "";
  }
  const bool all = inverted == loaded.mesh.element_count();
  return fmt::format("has {} inverted and {} flat elements of {}{}:{}", inverted,
                     culprits.size() - static_cast<std::size_t>(inverted), loaded.mesh.element_count(),
                     all ? ", all of them: its numbering is left-handed; exchange two corners of every element "
                           "or mirror it"
                         : " (finer or straight-sided elements may help)",
                     listed(culprits));
}

std::string problem_of_faces(const GmshMesh& loaded) {
  std::vector<std::string> culprits;
  for_each_shared_face(loaded.mesh, [&](std::span<const ElementFace> faces) {
    for (std::size_t i = 2; i < faces.size(); ++i) {
      culprits.push_back(element_text(loaded, faces[i].element));
    }
  });
  return culprits.empty()
             ? ""
             : fmt::format("has faces that more than two elements share, so elements overlap:{}", listed(culprits));
}

void check_connected(const scene::Body& body, const GmshMesh& loaded) {
  const std::vector<Index> part_of = connected_parts(loaded.mesh);
  std::vector<bool> seen(part_of.size(), false);
  std::vector<std::string> parts;
  for (Index element = 0; element < loaded.mesh.element_count(); ++element) {
    const Index part = part_of[loaded.mesh.element_nodes(element)[0]];
    if (!seen[part]) {
      seen[part] = true;
      parts.push_back(element_text(loaded, element));
    }
  }
  if (parts.size() > 1) {
    refuse(body, falling_apart(parts.size()) + ". One element of each:" + listed(parts));
  }
}

}  // namespace

void drop_unused_nodes(const scene::Body& body, GmshMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  std::vector<Index> renumbered(mesh.nodes.size(), -1);
  for (const Index node : mesh.elements) {
    renumbered[node] = 0;
  }
  Index used = 0;
  for (std::size_t node = 0; node < renumbered.size(); ++node) {
    if (renumbered[node] == 0) {
      renumbered[node] = used;
      mesh.nodes[used] = mesh.nodes[node];
      loaded.node_tags[used] = loaded.node_tags[node];
      ++used;
    }
  }
  const auto renumber = [&](Index& node) { node = renumbered[node]; };
  for (auto& [name, nodes] : mesh.groups) {
    std::vector<std::string> culprits;
    for (const Index node : nodes) {
      if (renumbered[node] < 0) {
        culprits.push_back(fmt::format("node {}", loaded.node_tags[node]));
      }
    }
    if (!culprits.empty()) {
      refuse(body, fmt::format("has {} nodes in its group '{}' that belong to no element:{}", culprits.size(), name,
                               listed(culprits)));
    }
    std::ranges::for_each(nodes, renumber);
  }
  for (auto& [name, triangles] : mesh.group_triangles) {
    std::ranges::for_each(triangles, [&](Triangle& triangle) { std::ranges::for_each(triangle, renumber); });
  }
  std::ranges::for_each(mesh.elements, renumber);
  mesh.nodes.resize(used);
  loaded.node_tags.resize(used);
}

std::string element_text(std::size_t tag, const Vector3& centre) {
  return fmt::format("element {} at {}", tag, to_text(centre));
}

std::string element_text(const GmshMesh& loaded, Index element) {
  return element_text(loaded.element_tags[element], centre_of(shape_of(loaded.mesh, element)));
}

void refuse_culprits(const scene::Body& body, const std::string& why, const std::vector<std::string>& culprits) {
  refuse(body, why + listed(culprits));
}

void refuse_elements(const scene::Body& body, const GmshMesh& loaded, const std::vector<Index>& elements,
                     const std::string& why) {
  std::vector<std::string> culprits;
  std::ranges::transform(elements, std::back_inserter(culprits),
                         [&](Index element) { return element_text(loaded, element); });
  refuse_culprits(body, why + ":", culprits);
}

std::string text_of_problem(const scene::Body& body, const std::string& problem) {
  return fmt::format("the mesh of body '{}', {}, {}", body.name, body.mesh.string(), problem);
}

void check_nodes(const scene::Body& body, const GmshMesh& loaded) {
  check_size(body, loaded);
  check_places(body, loaded);
}

std::string falling_apart(std::size_t parts) {
  return fmt::format("falls into {} parts that share no node; make each a body of its own, or join them", parts);
}

std::string problem_of_elements(const GmshMesh& loaded) {
  const std::string problem = problem_of_shapes(loaded);
  return problem.empty() ? problem_of_faces(loaded) : problem;
}

void check(const scene::Body& body, const GmshMesh& loaded) {
  check_nodes(body, loaded);
  require_none(body, problem_of_elements(loaded));
  check_connected(body, loaded);
}

}  // namespace idiophone::mesh

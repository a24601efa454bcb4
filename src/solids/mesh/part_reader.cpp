#include "part_reader.hpp"

#include <algorithm>

#include "checks.hpp"
#include "curve_division.hpp"
#include "element_measures.hpp"
#include "element_reader.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_table_reader.hpp"
#include "neighbourhood.hpp"
#include "owners.hpp"
#include "part_builder.hpp"

namespace idiophone::mesh {

namespace {

/// Places of nodes with ascending numbers, m. Reads across small gaps.
std::vector<Vector3> nodes_at(const MeshTables& tables, std::span<const std::size_t> numbers) {
  constexpr std::size_t small_gap = 1000;
  std::vector<Vector3> nodes;
  for (auto first = numbers.begin(); first != numbers.end();) {
    const auto last =
        std::adjacent_find(first, numbers.end(), [](std::size_t a, std::size_t b) { return b - a > small_gap; });
    const auto end = last == numbers.end() ? last : last + 1;
    const auto rows = tables.read_rows<double, Vector3>(mesh_file::nodes, 3, static_cast<Index>(*first),
                                                        static_cast<Index>(*(end - 1)) + 1);
    std::transform(first, end, std::back_inserter(nodes), [&](std::size_t number) { return rows[number - *first]; });
    first = end;
  }
  return nodes;
}

/// The place of a node in a part.
/// @throws std::runtime_error where the part does not have it
Index place_of(Index node, std::span<const std::size_t> tags) {
  const auto place = std::ranges::lower_bound(tags, static_cast<std::size_t>(node));
  if (place == tags.end() || std::cmp_not_equal(*place, node)) {
    refuse_table(mesh_file::surface, "has a triangle that is on no element");
  }
  return static_cast<Index>(place - tags.begin());
}

}  // namespace

PartReader::PartReader(std::span<const scene::Body> bodies, const Outlines& outlines,
                       std::span<const std::vector<Index>> coupled, MPI_Comm communicator)
    : bodies_(bodies),
      outlines_(outlines),
      coupled_(coupled),
      communicator_(communicator),
      rank_(parallel::rank_of(communicator)) {}

ReadPart PartReader::read() {
  take_elements();
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    take_nodes(body);
    take_surface(body);
    require_fit(body, problem_of_elements(around_[body]));
    const Index pieces = count_connected(around_[body], outlines_.offsets.nodes[body], first_, communicator_);
    require_fit(body, pieces == 1 ? "" : falling_apart(static_cast<std::size_t>(pieces)));
  }
  number_vertices();
  ReadPart result{.part = build(), .statistics = {}};
  result.statistics = statistics_of(result.part);
  return result;
}

void PartReader::take_elements() {
  const Offsets& offsets = outlines_.offsets;
  std::vector<ElementRows> rows;
  WorkOfNodes work(offsets.nodes.back());
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    const Index first_node = offsets.nodes[body];
    rows.push_back(read_element_rows(bodies_[body], outline(body), offsets.elements[body + 1] - offsets.elements[body],
                                     offsets.nodes[body + 1] - first_node, communicator_));
    for (const Index node : rows.back().nodes) {
      work.add(first_node + node, work_of_node(bodies_[body].element));
    }
  }
  first_ = work.divide(communicator_);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    around_.push_back(
        elements_around(std::move(rows[body]), bodies_[body], offsets.nodes[body], first_, communicator_));
  }
}

void PartReader::take_nodes(std::size_t body) {
  const auto [begin, end] = owned(body);
  const Index first_node = outlines_.offsets.nodes[body];
  std::vector<Index> others;
  for (const auto& set : coupled_) {
    for (const Index node : needed(set)) {
      if (node >= first_node && node < outlines_.offsets.nodes[body + 1]) {
        others.push_back(node - first_node);
      }
    }
  }
  GmshMesh& loaded = around_[body];
  require_fit(body, number_nodes(loaded, begin, end, std::move(others)));
  read_together(bodies_[body], communicator_,
                [&] { loaded.mesh.nodes = nodes_at(MeshTables(bodies_[body].mesh), loaded.node_tags); });
}

/// Triangles are sorted by their lowest nodes, so a rank owns a range of them.
void PartReader::take_surface(std::size_t body) {
  std::vector<Index> begins;
  for (const Index node : first_) {
    const Index own = node - outlines_.offsets.nodes[body];
    const auto& surface = outline(body).surface;
    begins.push_back(static_cast<Index>(
        std::ranges::lower_bound(surface, own, {}, [](const Triangle& triangle) { return triangle.front(); }) -
        surface.begin()));
  }
  parallel::broadcast(begins, communicator_);
  first_triangle_.push_back(begins[rank_]);
  GmshMesh& loaded = around_[body];
  read_together(bodies_[body], communicator_, [&] {
    loaded.mesh.surface = MeshTables(bodies_[body].mesh)
                              .read_rows<Index, Triangle>(mesh_file::surface, 3, begins[rank_], begins[rank_ + 1]);
    for (Triangle& triangle : loaded.mesh.surface) {
      std::ranges::for_each(triangle, [&](Index& node) { node = place_of(node, loaded.node_tags); });
    }
  });
}

void PartReader::number_vertices() {
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const Triangle& triangle : outline(body).surface) {
      std::ranges::transform(triangle, std::back_inserter(surface_nodes_),
                             [&](Index node) { return outlines_.offsets.nodes[body] + node; });
    }
  }
  keep_each_once(surface_nodes_);
  parallel::broadcast(surface_nodes_, communicator_);
}

Part PartReader::build() {
  std::vector<int> owners;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const std::size_t tag : around_[body].node_tags) {
      node_numbers_.push_back(outlines_.offsets.nodes[body] + static_cast<Index>(tag));
      owners.push_back(owner_of(node_numbers_.back(), first_));
    }
    meshes_.push_back(std::move(around_[body].mesh));
  }
  std::vector<std::vector<Index>> coupled;
  for (const auto& set : coupled_) {
    auto& here = coupled.emplace_back();
    std::ranges::transform(needed(set), std::back_inserter(here), [&](Index node) {
      return static_cast<Index>(std::ranges::lower_bound(node_numbers_, node) - node_numbers_.begin());
    });
  }
  Part part = PartBuilder(meshes_, std::move(owners), coupled).build(rank_);
  renumber(part);
  return part;
}

void PartReader::renumber(Part& part) const {
  const Offsets here = offsets(meshes_);
  const Offsets& all = outlines_.offsets;
  part.global_nodes = all.nodes.back();
  part.global_elements = all.elements.back();
  part.global_triangles = all.triangles.back();
  part.global_vertices = static_cast<Index>(surface_nodes_.size());
  std::ranges::for_each(part.node_ids, [&](Index& node) { node = node_numbers_[node]; });
  for (std::size_t ghost = 0; ghost < part.ghost_index.size(); ++ghost) {
    part.ghost_index[ghost] = part.node_ids[part.owned_nodes + ghost] - first_[part.ghost_rank[ghost]];
  }
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    BodyPart& share = part.bodies[body];
    share.first_element = all.elements[body];
    share.global_elements = all.elements[body + 1] - all.elements[body];
    for (Index& element : share.element_ids) {
      element = all.elements[body] + static_cast<Index>(around_[body].element_tags[element - here.elements[body]]);
    }
  }
  for (std::size_t triangle = 0; triangle < part.triangle_ids.size(); ++triangle) {
    const Index body = part.triangle_body[triangle];
    part.triangle_ids[triangle] += all.triangles[body] + first_triangle_[body] - here.triangles[body];
  }
  std::ranges::transform(part.vertices, part.vertex_ids.begin(), [&](Index vertex) {
    const auto place = std::ranges::lower_bound(surface_nodes_, part.node_ids[vertex]);
    return static_cast<Index>(place - surface_nodes_.begin());
  });
}

std::vector<Statistics> PartReader::statistics_of(const Part& part) const {
  std::vector<Box> boxes;
  std::ranges::transform(outlines_.meshes, std::back_inserter(boxes), box_of);
  parallel::broadcast(boxes, communicator_);
  std::vector<Statistics> result;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    ElementMeasures own = measures_of(meshes_[body], boxes[body].axes, part.bodies[body].owned);
    if (own.elements > 0) {
      own.worst_element = static_cast<Index>(around_[body].element_tags[own.worst_element]);
    }
    ElementMeasures all;
    std::ranges::for_each(parallel::gather(own, communicator_), [&](const auto& other) { all.add(other); });
    if (parallel::is_root(communicator_)) {
      result.push_back(statistics(outlines_.meshes[body], boxes[body], all));
    }
  }
  return result;
}

void PartReader::require_fit(std::size_t body, const std::string& problem) const {
  require_none(bodies_[body], problem.empty() ? "" : text_of_problem(bodies_[body], problem), communicator_);
}

const Mesh& PartReader::outline(std::size_t body) const {
  static const Mesh none;
  return outlines_.meshes.empty() ? none : outlines_.meshes[body];
}

std::pair<Index, Index> PartReader::owned(std::size_t body) const {
  const auto& nodes = outlines_.offsets.nodes;
  const auto in_body = [&](Index node) { return std::clamp(node, nodes[body], nodes[body + 1]) - nodes[body]; };
  return {in_body(first_[rank_]), in_body(first_[rank_ + 1])};
}

std::span<const Index> PartReader::needed(const std::vector<Index>& set) const {
  const bool any = std::ranges::any_of(set, [&](Index node) { return owner_of(node, first_) == rank_; });
  return any ? std::span(set) : std::span<const Index>();
}

}  // namespace idiophone::mesh

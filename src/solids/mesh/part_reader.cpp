#include "part_reader.hpp"

#include <algorithm>

#include "checks.hpp"
#include "curve_division.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "neighbourhood.hpp"
#include "owners.hpp"
#include "part_builder.hpp"
#include "part_statistics.hpp"
#include "part_tables.hpp"
#include "put_in_place.hpp"
#include "together.hpp"

namespace idiophone::mesh {

PartReader::PartReader(std::span<const scene::Body> bodies, MeshShares& shares,
                       std::span<const std::vector<Index>> coupled, MPI_Comm communicator)
    : bodies_(bodies),
      shares_(shares),
      coupled_(coupled),
      communicator_(communicator),
      rank_(parallel::rank_of(communicator)) {
  numbers_.all = shares.offsets;
}

ReadPart PartReader::read() {
  take_elements();
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    take_nodes(body);
    take_surface(body);
    check(body);
    check_together(communicator_, [&] { put_in_place(bodies_[body], around_[body].mesh.nodes); });
  }
  number_vertices();
  ReadPart result{.part = build(), .statistics = {}};
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    const Statistics found = gathered_statistics(outline(body), meshes_[body], result.part.bodies[body].owned,
                                                 numbers_.elements[body], bodies_[body].regions.size(), communicator_);
    if (rank_ == 0) {
      result.statistics.push_back(found);
    }
  }
  return result;
}

void PartReader::take_elements() {
  const Offsets& all = numbers_.all;
  WorkOfNodes work(all.nodes.back());
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const Index node : shares_.rows[body].nodes) {
      work.add(all.nodes[body] + node, work_of_node(bodies_[body].element));
    }
  }
  numbers_.first = work.divide(communicator_);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    Neighbourhood taken =
        elements_around(std::move(shares_.rows[body]), bodies_[body], all.nodes[body], numbers_.first, communicator_);
    around_.push_back(std::move(taken.loaded));
    numbers_.elements.push_back(std::move(taken.numbers));
  }
}

void PartReader::take_nodes(std::size_t body) {
  const auto [begin, end] = owned(body);
  const Index first_node = numbers_.all.nodes[body];
  std::vector<Index> others;
  for (const auto& set : coupled_) {
    for (const Index node : needed(set)) {
      if (node >= first_node && node < numbers_.all.nodes[body + 1]) {
        others.push_back(node - first_node);
      }
    }
  }
  GmshMesh& loaded = around_[body];
  require_fit(bodies_[body], number_nodes(loaded, begin, end, std::move(others)), communicator_);
  read_together(bodies_[body], communicator_, [&] { loaded.mesh.nodes = read_nodes(bodies_[body], loaded.node_tags); });
}

/// Triangles are sorted by their lowest nodes, so a rank owns a range of them.
void PartReader::take_surface(std::size_t body) {
  std::vector<Index> begins;
  for (const Index node : numbers_.first) {
    const Index own = node - numbers_.all.nodes[body];
    const auto& surface = outline(body).surface;
    begins.push_back(static_cast<Index>(
        std::ranges::lower_bound(surface, own, {}, [](const Triangle& triangle) { return triangle.front(); }) -
        surface.begin()));
  }
  parallel::broadcast(begins, communicator_);
  numbers_.first_triangle.push_back(begins[rank_]);
  GmshMesh& loaded = around_[body];
  read_together(bodies_[body], communicator_, [&] {
    loaded.mesh.surface = read_triangles(bodies_[body], begins[rank_], begins[rank_ + 1], loaded.node_tags);
  });
}

void PartReader::check(std::size_t body) const {
  require_fit(bodies_[body], problem_of_elements(around_[body]), communicator_);
  const Index pieces = count_connected(around_[body], numbers_.all.nodes[body], numbers_.first, communicator_);
  require_fit(bodies_[body], pieces == 1 ? "" : falling_apart(static_cast<std::size_t>(pieces)), communicator_);
}

void PartReader::number_vertices() {
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const Triangle& triangle : outline(body).surface) {
      std::ranges::transform(triangle, std::back_inserter(numbers_.surface_nodes),
                             [&](Index node) { return numbers_.all.nodes[body] + node; });
    }
  }
  keep_each_once(numbers_.surface_nodes);
  parallel::broadcast(numbers_.surface_nodes, communicator_);
}

Part PartReader::build() {
  std::vector<int> owners;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const std::size_t tag : around_[body].node_tags) {
      numbers_.nodes.push_back(numbers_.all.nodes[body] + static_cast<Index>(tag));
      owners.push_back(owner_of(numbers_.nodes.back(), numbers_.first));
    }
    meshes_.push_back(std::move(around_[body].mesh));
  }
  std::vector<std::vector<Index>> coupled;
  for (const auto& set : coupled_) {
    auto& here = coupled.emplace_back();
    std::ranges::transform(needed(set), std::back_inserter(here), [&](Index node) {
      return static_cast<Index>(std::ranges::lower_bound(numbers_.nodes, node) - numbers_.nodes.begin());
    });
  }
  Part part = PartBuilder(meshes_, std::move(owners), coupled).build(rank_);
  numbers_.here = offsets(meshes_);
  numbers_.renumber(part);
  return part;
}

const Mesh& PartReader::outline(std::size_t body) const {
  static const Mesh none;
  return shares_.outlines.empty() ? none : shares_.outlines[body];
}

std::pair<Index, Index> PartReader::owned(std::size_t body) const {
  const auto& nodes = numbers_.all.nodes;
  const auto in_body = [&](Index node) { return std::clamp(node, nodes[body], nodes[body + 1]) - nodes[body]; };
  return {in_body(numbers_.first[rank_]), in_body(numbers_.first[rank_ + 1])};
}

std::span<const Index> PartReader::needed(const std::vector<Index>& set) const {
  const bool any = std::ranges::any_of(set, [&](Index node) { return owner_of(node, numbers_.first) == rank_; });
  return any ? std::span(set) : std::span<const Index>();
}

}  // namespace idiophone::mesh

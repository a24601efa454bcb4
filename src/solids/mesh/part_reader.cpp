#include "part_reader.hpp"

#include <algorithm>

#include "checks.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "neighbourhood.hpp"
#include "owners.hpp"
#include "part_builder.hpp"
#include "part_statistics.hpp"
#include "part_tables.hpp"
#include "put_in_place.hpp"
#include "surface_reader.hpp"
#include "together.hpp"
#include "whole_columns.hpp"

namespace idiophone::mesh {

PartReader::PartReader(std::span<const scene::Body> bodies, const std::vector<Mesh>& outlines, const Offsets& offsets,
                       std::vector<ElementRows>& rows, std::span<const std::vector<Index>> coupled,
                       MPI_Comm communicator)
    : bodies_(bodies),
      outlines_(outlines),
      rows_(rows),
      coupled_(coupled),
      communicator_(communicator),
      process_(parallel::rank_of(communicator)) {
  numbers_.all = offsets;
}

ReadPart PartReader::read() {
  take_elements(parallel::size_of(communicator_));
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    take_nodes(body);
    take_surface(body);
    check(body);
    check_together(communicator_, [&] { put_in_place(bodies_[body], around_[body].mesh.nodes); });
  }
  number_vertices();
  ReadPart result;
  build([&](Part& part) { result.part = std::move(part); });
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    const Statistics found = gathered_statistics(outline(body), meshes_[body], result.part.bodies[body].owned,
                                                 numbers_.elements[body], bodies_[body].regions.size(), communicator_);
    if (process_ == 0) {
      result.statistics.push_back(found);
    }
  }
  return result;
}

void PartReader::for_each_part(int ranks, const std::function<void(const Part&)>& visit) {
  take_elements(ranks);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    take_nodes(body);
    take_surface(body);
  }
  number_vertices();
  build(visit);
}

void PartReader::take_elements(int ranks) {
  const Offsets& all = numbers_.all;
  WorkOfNodes work(all.nodes.back());
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const Index node : rows_[body].nodes) {
      work.add(all.nodes[body] + node, work_of_node(bodies_[body].element));
    }
  }
  std::vector<Index> first = work.divide(ranks, communicator_);
  std::vector<MovedNode> moved = nodes_moved_to_columns(bodies_, rows_, all.nodes, first, communicator_);
  division_.emplace(std::move(first), std::move(moved), parallel::size_of(communicator_));
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    Neighbourhood taken =
        elements_around(std::move(rows_[body]), bodies_[body], all.nodes[body], *division_, communicator_);
    around_.push_back(std::move(taken.loaded));
    numbers_.elements.push_back(std::move(taken.numbers));
  }
}

void PartReader::take_nodes(std::size_t body) {
  const auto [begin, end] = range(body);
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
  require_fit(bodies_[body], number_nodes(loaded, begin, end, away(body), std::move(others)), communicator_);
  read_together(bodies_[body], communicator_, [&] { loaded.mesh.nodes = read_nodes(bodies_[body], loaded.node_tags); });
}

void PartReader::take_surface(std::size_t body) {
  GmshMesh& loaded = around_[body];
  SurfaceRows rows = surface_around(bodies_[body], outline(body), numbers_.all.nodes[body], loaded.node_tags,
                                    *division_, communicator_);
  loaded.mesh.surface = std::move(rows.triangles);
  numbers_.triangles.push_back(std::move(rows.numbers));
}

void PartReader::check(std::size_t body) const {
  require_fit(bodies_[body], problem_of_elements(around_[body]), communicator_);
  const Index pieces = count_connected(around_[body], numbers_.all.nodes[body], *division_, communicator_);
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

void PartReader::build(const std::function<void(Part&)>& visit) {
  std::vector<int> owners;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    for (const std::size_t tag : around_[body].node_tags) {
      numbers_.nodes.push_back(numbers_.all.nodes[body] + static_cast<Index>(tag));
      owners.push_back(division_->owner_of(numbers_.nodes.back()));
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
  PartBuilder builder(meshes_, std::move(owners), coupled);
  numbers_.here = offsets(meshes_);
  const auto [begin, end] = division_->ranks_of(process_);
  for (int rank = begin; rank < end; ++rank) {
    Part part = builder.build(rank);
    numbers_.renumber(part, *division_);
    visit(part);
  }
}

const Mesh& PartReader::outline(std::size_t body) const {
  static const Mesh none;
  return outlines_.empty() ? none : outlines_[body];
}

std::pair<Index, Index> PartReader::range(std::size_t body) const {
  const auto& nodes = numbers_.all.nodes;
  const auto in_body = [&](Index node) { return std::clamp(node, nodes[body], nodes[body + 1]) - nodes[body]; };
  const auto [begin, end] = division_->range_of(process_);
  return {in_body(begin), in_body(end)};
}

std::vector<Index> PartReader::away(std::size_t body) const {
  const auto& nodes = numbers_.all.nodes;
  std::vector<Index> away = division_->away_from(process_);
  std::erase_if(away, [&](Index node) { return node < nodes[body] || node >= nodes[body + 1]; });
  std::ranges::for_each(away, [&](Index& node) { node -= nodes[body]; });
  return away;
}

std::span<const Index> PartReader::needed(const std::vector<Index>& set) const {
  const bool any = std::ranges::any_of(set, [&](Index node) { return division_->process_of(node) == process_; });
  return any ? std::span(set) : std::span<const Index>();
}

}  // namespace idiophone::mesh

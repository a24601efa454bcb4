#include "idiophone/run/record/stored_body.hpp"

#include <algorithm>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::record {

namespace {

/// Numbers within the body of what this rank owns of it.
parallel::Rows node_rows(const mesh::Part& part, const mesh::Offsets& offsets, std::size_t b, MPI_Comm communicator) {
  const auto& body = part.bodies[b];
  std::vector<Index> numbers;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    numbers.push_back(part.node_ids[node] - offsets.nodes[b]);
  }
  return {numbers, offsets.nodes[b + 1] - offsets.nodes[b], communicator};
}

/// Numbers within the body of the cells that this rank's owned elements are drawn as.
parallel::Rows cell_rows(const mesh::Part& part, const mesh::Offsets& offsets, std::size_t b, MPI_Comm communicator) {
  const auto& body = part.bodies[b];
  std::vector<Index> numbers;
  const auto cells = static_cast<Index>(element::reference(body.element).drawn.cells.size());
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    for (Index cell = 0; body.owned[e] != 0 && cell < cells; ++cell) {
      numbers.push_back((body.element_ids[e] - offsets.elements[b]) * cells + cell);
    }
  }
  return {numbers, std::int64_t{offsets.elements[b + 1] - offsets.elements[b]} * cells, communicator};
}

/// Node numbers within the body of those cells. [nodes per cell x cells]
std::vector<Index> connectivity(const mesh::Part& part, const mesh::BodyPart& body, Index first_node) {
  const auto& cells = element::reference(body.element).drawn.cells;
  std::vector<Index> nodes;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    if (body.owned[e] == 0) {
      continue;
    }
    const auto element_nodes = body.element_nodes(e);
    for (const std::vector<int>& cell : cells) {
      std::ranges::transform(cell, std::back_inserter(nodes),
                             [&](int place) { return part.node_ids[element_nodes[place]] - first_node; });
    }
  }
  return nodes;
}

}  // namespace

StoredBody::StoredBody(std::string name, const mesh::Part& part, const mesh::Offsets& offsets, std::size_t number,
                       MPI_Comm communicator)
    : name_(std::move(name)),
      part_(part),
      body_(part.bodies[number]),
      first_node_(offsets.nodes[number]),
      nodes_(node_rows(part, offsets, number, communicator)),
      cells_(cell_rows(part, offsets, number, communicator)) {}

void StoredBody::add_mesh(results::ResultFile& result) const {
  std::vector<double> reference;
  for (Index node = body_.owned_begin; node < body_.owned_end; ++node) {
    const Vector3& x = part_.reference[node];
    reference.insert(reference.end(), x.begin(), x.end());
  }
  result.add_mesh(name_, nodes_, reference, cells_, connectivity(part_, body_, first_node_), body_.element);
}

}  // namespace idiophone::record

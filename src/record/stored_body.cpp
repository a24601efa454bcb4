#include "idiophone/record/stored_body.hpp"

#include <algorithm>

#include "idiophone/element/reference.hpp"

namespace idiophone::record {

namespace {

/// Numbers within the body of what this rank owns of it.
parallel::Rows node_rows(const mesh::Part& part, const mesh::Offsets& offsets, std::size_t b, MPI_Comm communicator) {
  const auto& body = part.bodies[b];
  std::vector<Index> numbers;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    numbers.push_back(part.node_ids[static_cast<std::size_t>(node)] - offsets.nodes[b]);
  }
  return {numbers, offsets.nodes[b + 1] - offsets.nodes[b], communicator};
}

parallel::Rows element_rows(const mesh::Part& part, const mesh::Offsets& offsets, std::size_t b,
                            MPI_Comm communicator) {
  const auto& body = part.bodies[b];
  std::vector<Index> numbers;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    if (body.owned[e] != 0) {
      numbers.push_back(body.element_ids[e] - offsets.elements[b]);
    }
  }
  return {numbers, offsets.elements[b + 1] - offsets.elements[b], communicator};
}

/// Node numbers within the body of its owned elements, in the order in which they are drawn. [nodes per element x owned
/// elements]
std::vector<Index> connectivity(const mesh::Part& part, const mesh::BodyPart& body, Index first_node) {
  const std::vector<int>& order = element::reference(body.element).drawn.nodes;
  std::vector<Index> nodes;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    if (body.owned[e] != 0) {
      const auto element_nodes = body.element_nodes(e);
      std::ranges::transform(order, std::back_inserter(nodes),
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
      elements_(element_rows(part, offsets, number, communicator)) {}

void StoredBody::add_mesh(store::ResultFile& result) const {
  std::vector<double> reference;
  for (Index node = body_.owned_begin; node < body_.owned_end; ++node) {
    const Vector3& x = part_.reference[static_cast<std::size_t>(node)];
    reference.insert(reference.end(), x.begin(), x.end());
  }
  result.add_mesh(name_, nodes_, reference, elements_, connectivity(part_, body_, first_node_), body_.element);
}

}  // namespace idiophone::record

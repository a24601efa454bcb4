#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "owners.hpp"
#include "part_builder.hpp"
#include "part_message.hpp"

namespace idiophone::mesh {

namespace {

/// The sum of the sizes so far; so many node numbers of elements, the longest of all lists, have to fit an Index.
Index next_offset(Index offset, std::size_t size, const char* what) {
  const std::int64_t next = offset + static_cast<std::int64_t>(size);
  if (next > std::numeric_limits<Index>::max()) {
    throw std::runtime_error(fmt::format("the meshes have {} {} together, more than the {} that can be numbered", next,
                                         what, std::numeric_limits<Index>::max()));
  }
  return static_cast<Index>(next);
}

}  // namespace

Offsets offsets_of(const std::vector<Mesh>& meshes, std::span<const Index> elements) {
  Offsets first{.nodes = {0}, .elements = {0}, .triangles = {0}};
  Index element_nodes = 0;
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    const Mesh& mesh = meshes[body];
    first.nodes.push_back(next_offset(first.nodes.back(), mesh.nodes.size(), "nodes"));
    const auto width = static_cast<std::size_t>(element::node_count(mesh.element));
    element_nodes = next_offset(element_nodes, width * static_cast<std::size_t>(elements[body]), "nodes of elements");
    first.elements.push_back(first.elements.back() + elements[body]);
    first.triangles.push_back(next_offset(first.triangles.back(), mesh.surface.size(), "surface triangles"));
  }
  return first;
}

Offsets offsets(const std::vector<Mesh>& meshes) {
  std::vector<Index> elements;
  std::ranges::transform(meshes, std::back_inserter(elements), &Mesh::element_count);
  return offsets_of(meshes, elements);
}

Part distribute(const std::vector<Mesh>& meshes, MPI_Comm communicator, std::span<const std::vector<Index>> coupled) {
  const int rank = parallel::rank_of(communicator);
  const int ranks = parallel::size_of(communicator);
  std::optional<PartBuilder> builder;
  std::optional<parallel::Messages> messages;  // to the receiver before, while the next part is built
  Part own;
  parallel::on_root(communicator, [&] {
    builder.emplace(meshes, node_owners(meshes, ranks), coupled);
    own = builder->build(0);
  });
  for (int receiver = 1; receiver < ranks; ++receiver) {
    Part part;
    parallel::on_root(communicator, [&] { part = builder->build(receiver); });
    if (rank == 0) {
      messages.emplace(communicator);
      send_part(std::move(part), receiver, *messages);
    } else if (rank == receiver) {
      own = receive_part(communicator);
    }
  }
  return own;
}

}  // namespace idiophone::mesh

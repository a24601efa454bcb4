#include "part_message.hpp"

#include <utility>

namespace idiophone::mesh {

namespace {

constexpr int part_tag = 0;

template <class Member>
inline constexpr bool is_list = false;
template <class Item>
inline constexpr bool is_list<std::vector<Item>> = true;

/// Calls transfer(list or number) for everything that a part holds, in the same order on both sides.
template <class Transfer>
void for_each_member(Part& part, const Transfer& transfer) {
  transfer(part.global_nodes), transfer(part.global_elements);
  transfer(part.global_triangles), transfer(part.global_vertices);
  transfer(part.owned_nodes);
  transfer(part.node_ids), transfer(part.reference), transfer(part.ghost_rank), transfer(part.ghost_index);
  transfer(part.surface), transfer(part.triangle_ids), transfer(part.triangle_body);
  transfer(part.vertices), transfer(part.vertex_ids);
  transfer(part.first_piece), transfer(part.pieces);
  for (auto& body : part.bodies) {
    transfer(body.element), transfer(body.owned_begin), transfer(body.owned_end);
    transfer(body.first_element), transfer(body.global_elements);
    transfer(body.element_ids), transfer(body.elements), transfer(body.owned), transfer(body.regions);
  }
}

}  // namespace

void send_part(Part part, int rank, parallel::Messages& messages) {
  messages.send(std::vector{part.bodies.size()}, rank, part_tag);
  for_each_member(part, [&]<class Member>(Member& member) {
    if constexpr (is_list<Member>) {
      messages.send(std::move(member), rank, part_tag);
    } else {
      messages.send(std::vector{member}, rank, part_tag);
    }
  });
}

Part receive_part(MPI_Comm communicator) {
  const parallel::Messages messages(communicator);
  Part part;
  part.bodies.resize(messages.receive<std::size_t>(0, part_tag).front());
  for_each_member(part, [&]<class Member>(Member& member) {
    if constexpr (is_list<Member>) {
      member = messages.receive<typename Member::value_type>(0, part_tag);
    } else {
      member = messages.receive<Member>(0, part_tag).front();
    }
  });
  return part;
}

}  // namespace idiophone::mesh

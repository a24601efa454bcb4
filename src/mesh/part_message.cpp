#include "part_message.hpp"

#include "idiophone/parallel/datatype.hpp"

namespace idiophone::mesh {

namespace {

constexpr int tag = 0;

/// Calls transfer(list or number) for everything that a part holds, in the same order on both sides.
template <class AnyPart, class Transfer>
void for_each_member(AnyPart& part, Transfer&& transfer) {
  transfer(part.global_nodes), transfer(part.global_elements);
  transfer(part.global_triangles), transfer(part.global_vertices);
  transfer(part.owned_nodes);
  transfer(part.node_ids), transfer(part.reference), transfer(part.ghost_rank), transfer(part.ghost_index);
  transfer(part.surface), transfer(part.triangle_ids), transfer(part.triangle_body);
  transfer(part.vertices), transfer(part.vertex_ids);
  for (auto& body : part.bodies) {
    transfer(body.element), transfer(body.owned_begin), transfer(body.owned_end);
    transfer(body.first_element), transfer(body.global_elements);
    transfer(body.element_ids), transfer(body.elements), transfer(body.owned);
  }
}

struct Sender {
  int rank;
  MPI_Comm communicator;

  template <class Number>
  void operator()(const Number& number) const {
    MPI_Send(&number, sizeof(Number), MPI_BYTE, rank, tag, communicator);
  }
  template <class Item>
  void operator()(const std::vector<Item>& list) const {
    MPI_Send(list.data(), static_cast<int>(list.size()), parallel::Datatype::of<Item>().get(), rank, tag, communicator);
  }
};

struct Receiver {
  MPI_Comm communicator;

  template <class Number>
  void operator()(Number& number) const {
    MPI_Recv(&number, sizeof(Number), MPI_BYTE, 0, tag, communicator, MPI_STATUS_IGNORE);
  }
  template <class Item>
  void operator()(std::vector<Item>& list) const {
    const parallel::Datatype type = parallel::Datatype::of<Item>();
    MPI_Status status;
    MPI_Probe(0, tag, communicator, &status);
    int items = 0;
    MPI_Get_count(&status, type.get(), &items);
    list.resize(items);
    MPI_Recv(list.data(), items, type.get(), 0, tag, communicator, MPI_STATUS_IGNORE);
  }
};

}  // namespace

void send_part(const Part& part, int rank, MPI_Comm communicator) {
  const Sender send{.rank = rank, .communicator = communicator};
  send(part.bodies.size());
  for_each_member(part, send);
}

Part receive_part(MPI_Comm communicator) {
  const Receiver receive{.communicator = communicator};
  Part part;
  std::size_t bodies = 0;
  receive(bodies);
  part.bodies.resize(bodies);
  for_each_member(part, receive);
  return part;
}

}  // namespace idiophone::mesh

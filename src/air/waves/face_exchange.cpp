#include "face_exchange.hpp"

#include <algorithm>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/messages.hpp"

namespace idiophone::waves {

namespace {

constexpr int pressure_tag = 0;
constexpr int node_tag = 1;

std::vector<Index> nodes_in(const CellBox& cells, const CutCells& cut_cells) {
  std::vector<Index> nodes;
  for_each_cell(cells, [&](const std::array<int, 3>& cell) {
    const auto [first, last] = cut_cells.nodes_of(cell);
    for (Index node = first; node < last; ++node) {
      nodes.push_back(node);
    }
  });
  return nodes;
}

CellBox moved(CellBox box, std::size_t axis, int cells) {
  box.from.at(axis) += cells;
  box.to.at(axis) += cells;
  return box;
}

}  // namespace

FaceExchange::FaceExchange(const Division& division, MPI_Comm communicator)
    : subdomain_(division.subdomain(parallel::rank_of(communicator))) {
  MPI_Comm_dup(communicator, &communicator_);
  for (const Face& face : division.faces(parallel::rank_of(communicator))) {
    neighbours_.push_back({.rank = face.neighbour,
                           .own_cells = moved(face.ghost_cells, face.axis, -face.direction),
                           .ghost_cells = face.ghost_cells,
                           .own_nodes = {},
                           .ghost_nodes = {},
                           .sent = {},
                           .received = {}});
  }
  requests_.resize(2 * neighbours_.size(), MPI_REQUEST_NULL);
  set_nodes(CutCells(subdomain_));
}

FaceExchange::~FaceExchange() {
  MPI_Comm_free(&communicator_);
}

void FaceExchange::set_nodes(const CutCells& cut_cells) {
  for (Neighbour& neighbour : neighbours_) {
    neighbour.own_nodes = nodes_in(neighbour.own_cells, cut_cells);
    neighbour.ghost_nodes = nodes_in(neighbour.ghost_cells, cut_cells);
    neighbour.sent.resize(neighbour.own_cells.size() + neighbour.own_nodes.size());
    neighbour.received.resize(neighbour.ghost_cells.size() + neighbour.ghost_nodes.size());
  }
}

void FaceExchange::add_places(const CellBox& cells, const std::vector<Index>& nodes, std::vector<Index>& places) const {
  for_each_row(cells, [&](Index first, int length) {
    for (int i = 0; i < length; ++i) {
      places.push_back(first + i);
    }
  });
  for (const Index node : nodes) {
    places.push_back(subdomain_.length() + node);
  }
}

std::vector<Index> FaceExchange::own_places() const {
  std::vector<Index> places;
  for (const Neighbour& neighbour : neighbours_) {
    add_places(neighbour.own_cells, neighbour.own_nodes, places);
  }
  keep_each_once(places);
  return places;
}

std::vector<Index> FaceExchange::ghost_places() const {
  std::vector<Index> places;
  for (const Neighbour& neighbour : neighbours_) {
    add_places(neighbour.ghost_cells, neighbour.ghost_nodes, places);
  }
  return places;
}

void FaceExchange::send() {
  MPI_Request* request = requests_.data();
  for (Neighbour& neighbour : neighbours_) {
    MPI_Irecv(neighbour.received.data(), static_cast<int>(neighbour.received.size()), MPI_FLOAT, neighbour.rank,
              pressure_tag, communicator_, request++);
    MPI_Isend(neighbour.sent.data(), static_cast<int>(neighbour.sent.size()), MPI_FLOAT, neighbour.rank, pressure_tag,
              communicator_, request++);
  }
}

void FaceExchange::finish(std::span<float> cells, std::span<float> nodes) {
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (const Neighbour& neighbour : neighbours_) {
    const float* value = neighbour.received.data();
    for_each_row(neighbour.ghost_cells, [&](Index first, int length) {
      std::copy_n(value, length, &cells[first]);
      value += length;
    });
    for (const Index node : neighbour.ghost_nodes) {
      nodes[node] = *value++;
    }
  }
}

void FaceExchange::exchange_nodes(std::span<float> values, std::size_t width) const {
  parallel::Messages messages(communicator_);
  for (const Neighbour& neighbour : neighbours_) {
    std::vector<float> sent;
    for (const Index node : neighbour.own_nodes) {
      const auto of_node = values.subspan(width * node, width);
      sent.insert(sent.end(), of_node.begin(), of_node.end());
    }
    messages.send(std::move(sent), neighbour.rank, node_tag);
  }
  for (const Neighbour& neighbour : neighbours_) {
    const std::vector<float> received = messages.receive<float>(neighbour.rank, node_tag);
    for (std::size_t i = 0; i < neighbour.ghost_nodes.size(); ++i) {
      std::copy_n(&received[width * i], width, &values[width * neighbour.ghost_nodes[i]]);
    }
  }
}

}  // namespace idiophone::waves

// What the ranks of a contact tell each other: where they are, which nodes they send, and how these move.

#include "meeting.hpp"

namespace idiophone::contact {

namespace {

enum Tag : int { tag_whereabouts, tag_nodes, tag_motion };

constexpr std::size_t bond_width = 5;    // place, stretch, sliding
constexpr std::size_t motion_width = 6;  // position, velocity

/// Sends messages without waiting until they have arrived; they live as long as this does.
class Outbox {
 public:
  void send(std::vector<double> message, int rank, int tag, MPI_Comm communicator) {
    messages_.push_back(std::move(message));
    MPI_Isend(messages_.back().data(), static_cast<int>(messages_.back().size()), MPI_DOUBLE, rank, tag, communicator,
              &requests_.emplace_back());
  }
  void wait() { MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

 private:
  std::vector<std::vector<double>> messages_;
  std::vector<MPI_Request> requests_;
};

std::vector<double> receive(int rank, int tag, MPI_Comm communicator) {
  MPI_Status status;
  MPI_Probe(rank, tag, communicator, &status);
  int size = 0;
  MPI_Get_count(&status, MPI_DOUBLE, &size);
  std::vector<double> message(static_cast<std::size_t>(size));
  MPI_Recv(message.data(), size, MPI_DOUBLE, rank, tag, communicator, MPI_STATUS_IGNORE);
  return message;
}

}  // namespace

void Meeting::tell(const Whereabouts& mine) {
  std::vector<double> message;
  for (const Box& box : mine.boxes) {
    message.insert(message.end(), box.min().begin(), box.min().end());
    message.insert(message.end(), box.max().begin(), box.max().end());
  }
  message.push_back(mine.speed);
  Outbox outbox;
  for (const Peer& peer : peers_) {
    outbox.send(message, peer.rank, tag_whereabouts, communicator_);
  }
  for (Peer& peer : peers_) {
    const std::vector<double> answer = receive(peer.rank, tag_whereabouts, communicator_);
    for (std::size_t s = 0; s < 2; ++s) {
      peer.whereabouts.boxes.at(s) = Box(Vector3(&answer[6 * s]), Vector3(&answer[6 * s + 3]));
    }
    peer.whereabouts.speed = answer.back();
  }
  outbox.wait();
}

void Meeting::announce() {
  std::vector<double> message = {static_cast<double>(sent_[0].size())};
  for (std::size_t s = 0; s < sides_; ++s) {
    for (const SkinNode& node : sent_.at(s)) {
      const Bond& bond = side(s).bond[static_cast<std::size_t>(node.place)];
      message.push_back(static_cast<double>(node.place));
      message.insert(message.end(), bond.stretch.begin(), bond.stretch.end());
      message.push_back(bond.sliding);
    }
  }
  Outbox outbox;
  for (const Peer& peer : peers_) {
    if (peer.near) {
      outbox.send(message, peer.rank, tag_nodes, communicator_);
    }
  }
  for (Peer& peer : peers_) {
    peer.nodes = {};
    if (!peer.near) {
      continue;
    }
    const std::vector<double> answer = receive(peer.rank, tag_nodes, communicator_);
    const auto first = static_cast<std::size_t>(answer[0]);
    for (std::size_t i = 0; bond_width * i + 1 < answer.size(); ++i) {
      const double* row = &answer[1 + bond_width * i];
      const std::size_t s = i < first ? 0 : 1;
      peer.nodes.at(s).push_back(static_cast<Index>(row[0]));
      side(s).bond[static_cast<std::size_t>(row[0])] = {Vector3(row + 1), row[4]};
    }
  }
  outbox.wait();
}

void Meeting::follow(const solid::NodeState* state) {
  std::vector<double> message;
  for (std::size_t s = 0; s < sides_; ++s) {
    for (const SkinNode& node : sent_.at(s)) {
      place(s, node, state);
      for (const Vector3* vector : {&side(s).position[static_cast<std::size_t>(node.place)],
                                    &side(s).velocity[static_cast<std::size_t>(node.place)]}) {
        message.insert(message.end(), vector->begin(), vector->end());
      }
    }
  }
  Outbox outbox;
  for (const Peer& peer : peers_) {
    if (peer.near && !message.empty()) {
      outbox.send(message, peer.rank, tag_motion, communicator_);
    }
  }
  for (const Peer& peer : peers_) {
    if (!peer.near || peer.nodes[0].size() + peer.nodes[1].size() == 0) {
      continue;
    }
    const std::vector<double> answer = receive(peer.rank, tag_motion, communicator_);
    const double* row = answer.data();
    for (std::size_t s = 0; s < sides_; ++s) {
      for (const Index place : peer.nodes.at(s)) {
        side(s).position[static_cast<std::size_t>(place)] = Vector3(row);
        side(s).velocity[static_cast<std::size_t>(place)] = Vector3(row + 3);
        row += motion_width;
      }
    }
  }
  outbox.wait();
}

}  // namespace idiophone::contact

#include "neighbour_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::contact {

namespace {

enum Tag : int { tag_bounds, tag_nodes, tag_states, tag_cells, tag_faces };

constexpr std::size_t state_width = 6;  // position, velocity

/// So many pairs of cells for each rank are worth a message: it takes about as long as the overlaps of some pairs.
constexpr std::size_t least_pairs = 8;

void append(const Vector3& vector, std::vector<double>& message) {
  message.insert(message.end(), vector.begin(), vector.end());
}

/// Numbers of a bond in a message, behind the place of its node.
std::size_t bond_width() {
  parallel::ArchiveRow numbers(parallel::ArchiveRow::Action::count);
  Bond{}.archive(numbers);
  return numbers.count();
}

void append(Bond bond, std::vector<double>& message) {
  std::vector<double> values(bond_width());
  parallel::ArchiveRow numbers(parallel::ArchiveRow::Action::save, values);
  bond.archive(numbers);
  message.insert(message.end(), values.begin(), values.end());
}

}  // namespace

NeighbourExchange::NeighbourExchange(std::vector<Side*> sides, const mesh::Part& part, MPI_Comm communicator)
    : sides_(std::move(sides)), rank_(parallel::rank_of(communicator)), sent_(sides_.size()) {
  for (Side* side : sides_) {
    for (const SkinNode& node : local_.emplace_back(find_local_skin(side->skin, part)).nodes) {
      side->reference[node.place] = part.reference[node.node];
    }
  }
  const std::vector<int> owners = parallel::gather(owns_nodes() ? 1 : 0, communicator);
  for (int rank = 0; rank < std::ssize(owners) && owns_nodes(); ++rank) {
    if (rank != rank_ && owners[rank] != 0) {
      peers_.push_back({rank, {}, false, {}});
    }
  }
}

bool NeighbourExchange::owns_nodes() const {
  return std::ranges::any_of(local_, [](const LocalSkin& skin) { return !skin.owned.empty(); });
}

void NeighbourExchange::send_bounds(std::span<const solid::NodeState> state, parallel::Messages& messages) {
  if (!owns_nodes()) {
    return;
  }
  own_ = local_bounds(state);
  std::vector<double> message;
  for (const Box& box : own_.boxes) {
    append(box.min(), message);
    append(box.max(), message);
  }
  append(own_.velocities.min(), message);
  append(own_.velocities.max(), message);
  message.push_back(own_.speed);
  for (const Peer& peer : peers_) {
    messages.send(message, peer.rank, tag_bounds);
  }
}

void NeighbourExchange::receive_bounds(BroadPhase& broad_phase, parallel::Messages& messages) {
  if (!owns_nodes()) {
    return;
  }
  Bounds whole = own_;
  for (Peer& peer : peers_) {
    const std::vector<double> answer = messages.receive<double>(peer.rank, tag_bounds);
    for (std::size_t s = 0; s < 2; ++s) {
      peer.bounds.boxes.at(s) = Box(Vector3(&answer[6 * s]), Vector3(&answer[6 * s + 3]));
    }
    peer.bounds.velocities = Box(Vector3(&answer[12]), Vector3(&answer[15]));
    peer.bounds.speed = answer.back();
    whole.extend(peer.bounds);
  }
  broad_phase.update(whole);
  participates_ = broad_phase.may_touch(own_);
  for (Peer& peer : peers_) {
    peer.participates = participates_ && broad_phase.may_touch(peer.bounds);
  }
  if (participates_) {
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      sent_[s] = broad_phase.near_nodes(s, local_[s]);
    }
    send_nodes(messages);
  }
}

Bounds NeighbourExchange::local_bounds(std::span<const solid::NodeState> state) {
  Bounds bounds;
  double squared_speed = 0.0;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    Side& side = *sides_[s];
    for (const SkinNode& node : local_[s].nodes) {
      contact::update(node, state, side);
      bounds.boxes.at(s).extend(side.position[node.place]);
    }
    for (const SkinNode& node : local_[s].owned) {
      bounds.velocities.extend(side.velocity[node.place]);
      squared_speed = std::max(squared_speed, side.velocity[node.place].squaredNorm());
    }
  }
  bounds.speed = std::sqrt(squared_speed);
  return bounds;
}

void NeighbourExchange::send_nodes(parallel::Messages& messages) const {
  std::vector<double> message = {static_cast<double>(sent_[0].size())};
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    for (const SkinNode& node : sent_[s]) {
      message.push_back(static_cast<double>(node.place));
      append(sides_[s]->bond[node.place], message);
    }
  }
  for (const Peer* peer : other_participants()) {
    messages.send(message, peer->rank, tag_nodes);
  }
}

void NeighbourExchange::receive_nodes(const parallel::Messages& messages) {
  for (Peer& peer : peers_) {
    peer.nodes = {};
    if (peer.participates) {
      take_nodes(messages.receive<double>(peer.rank, tag_nodes), peer);
    }
  }
}

void NeighbourExchange::take_nodes(std::vector<double> message, Peer& peer) {
  const auto first = static_cast<std::size_t>(message[0]);
  const std::size_t width = 1 + bond_width();
  for (std::size_t i = 0; width * i + 1 < message.size(); ++i) {
    const std::span<double> row = std::span(message).subspan(1 + width * i, width);
    const std::size_t s = i < first ? 0 : 1;
    const auto place = static_cast<Index>(row[0]);
    peer.nodes.at(s).push_back(place);
    parallel::ArchiveRow numbers(parallel::ArchiveRow::Action::restore, row.subspan(1));
    sides_[s]->bond[place].archive(numbers);
    sides_[s]->bonded.push_back(place);
  }
}

void NeighbourExchange::keep_nodes(std::size_t s, const std::vector<Index>& cells) {
  std::vector<char> kept(sides_[s]->skin.nodes.size());
  for (const Index cell : cells) {
    for (const Index place : sides_[s]->skin.cells[cell]) {
      kept[place] = 1;
    }
  }
  std::erase_if(sent_[s], [&](const SkinNode& node) { return kept[node.place] == 0; });
  for (Peer& peer : peers_) {
    std::erase_if(peer.nodes.at(s), [&](Index place) { return kept[place] == 0; });
  }
}

void NeighbourExchange::send_states(std::span<const solid::NodeState> state, parallel::Messages& messages) {
  std::vector<double> message;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    Side& side = *sides_[s];
    for (const SkinNode& node : sent_[s]) {
      contact::update(node, state, side);
      append(side.position[node.place], message);
      append(side.velocity[node.place], message);
    }
  }
  for (const Peer* peer : other_participants()) {
    if (!message.empty()) {
      messages.send(message, peer->rank, tag_states);
    }
  }
}

void NeighbourExchange::receive_states(const parallel::Messages& messages) {
  for (const Peer* peer : other_participants()) {
    if (peer->nodes[0].empty() && peer->nodes[1].empty()) {
      continue;
    }
    const std::vector<double> answer = messages.receive<double>(peer->rank, tag_states);
    const double* row = answer.data();
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      for (const Index place : peer->nodes.at(s)) {
        sides_[s]->position[place] = Vector3(row);
        sides_[s]->velocity[place] = Vector3(row + 3);
        row += state_width;
      }
    }
  }
}

Portion NeighbourExchange::portion(std::size_t pairs) const {
  const std::vector<const Peer*> others = other_participants();
  const std::size_t count = others.size() + 1;
  if (pairs < least_pairs * count) {
    return {};
  }
  const auto number = std::ranges::count_if(others, [&](const Peer* peer) { return peer->rank < rank_; });
  return {static_cast<std::size_t>(number), count};
}

void NeighbourExchange::send_overlaps(const Portion& portion, const Overlaps& overlaps,
                                      parallel::Messages& messages) const {
  if (portion.count == 1) {
    return;
  }
  for (const Peer* peer : other_participants()) {
    messages.send(overlaps.cells(), peer->rank, tag_cells);
    messages.send(overlaps.faces(), peer->rank, tag_faces);
  }
}

void NeighbourExchange::receive_overlaps(const Portion& portion, Overlaps& overlaps,
                                         const parallel::Messages& messages) const {
  if (portion.count == 1) {
    return;
  }
  const Overlaps own = std::exchange(overlaps, {});
  const std::vector<const Peer*> others = other_participants();
  auto other = others.begin();
  for (std::size_t number = 0; number < portion.count; ++number) {
    if (number == portion.number) {
      overlaps.append(own.cells(), own.faces());
    } else {
      overlaps.append(messages.receive<CellShare>((*other)->rank, tag_cells),
                      messages.receive<FaceShare>((*other)->rank, tag_faces));
      ++other;
    }
  }
}

void NeighbourExchange::withdraw() {
  participates_ = false;
  for (Peer& peer : peers_) {
    peer.participates = false;
  }
}

std::vector<const NeighbourExchange::Peer*> NeighbourExchange::other_participants() const {
  std::vector<const Peer*> others;
  for (const Peer& peer : peers_) {
    if (peer.participates) {
      others.push_back(&peer);
    }
  }
  return others;
}

bool NeighbourExchange::is_shared() const {
  return std::ranges::any_of(peers_, &Peer::participates);
}

bool NeighbourExchange::is_reporting_rank() const {
  return participates_ &&
         std::ranges::none_of(other_participants(), [&](const Peer* peer) { return peer->rank < rank_; });
}

std::vector<Index> NeighbourExchange::known_cells(std::size_t s) const {
  std::vector<char> known(sides_[s]->skin.nodes.size());
  for (const SkinNode& node : sent_[s]) {
    known[node.place] = 1;
  }
  for (const Peer& peer : peers_) {
    for (const Index place : peer.nodes.at(s)) {
      known[place] = 1;
    }
  }
  std::vector<Index> complete;
  const auto& cells = sides_[s]->skin.cells;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (std::ranges::all_of(cells[cell], [&](Index place) { return known[place] != 0; })) {
      complete.push_back(static_cast<Index>(cell));
    }
  }
  return complete;
}

}  // namespace idiophone::contact

#include "idiophone/solids/contact/contacts.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "broad_phase.hpp"
#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "interaction.hpp"
#include "mean_motion.hpp"
#include "neighbour_exchange.hpp"

namespace idiophone::contact {

struct Contacts::Pair {
  std::string name;
  Side first;
  std::optional<Side> second;  ///< none if the partner is an obstacle or the body itself
  const RigidShape* shape;     ///< null if the partner is a body
  BroadPhase broad_phase;
  NeighbourExchange exchange;
  Interaction interaction;
  Portion portion;  ///< of the overlaps, that this rank computes
  MeanMotion mean;
  ContactMotion motion;
  std::int64_t next_update = 0;  ///< step of the next one of the broad phase

  Pair(const scene::Contact& contact, double stiffness, const mesh::Part& part, const ContactSurfaces& contact_surfaces,
       double step, int steps_per_update, MPI_Comm communicator)
      : name(contact.name),
        first(contact_surfaces.skins[contact.body]),
        second(contact.other && *contact.other != contact.body
                   ? std::optional<Side>(contact_surfaces.skins[*contact.other])
                   : std::nullopt),
        shape(contact.obstacle ? &contact_surfaces.shapes[*contact.obstacle] : nullptr),
        broad_phase(sides(), shape, step * steps_per_update),
        exchange(sides(), part, communicator),
        interaction(shape == nullptr ? Interaction(contact, stiffness, step, first, second ? *second : first)
                                     : Interaction(contact, stiffness, step, first, *shape)) {}

  /// Those that are bodies': one or two.
  [[nodiscard]] std::vector<Side*> sides() {
    return second ? std::vector<Side*>{&first, &*second} : std::vector<Side*>{&first};
  }

  /// Visits the owned nodes of both sides, with the bond and the local number of each.
  template <class Visitor>
  void for_each_bond(Visitor visit) {
    const std::vector<Side*> both = sides();
    for (std::size_t s = 0; s < both.size(); ++s) {
      for (const SkinNode& node : exchange.owned(s)) {
        visit(both[s]->bond[node.place], node.node);
      }
    }
  }

  /// Chooses what may touch until the next update. The states of the participants' nodes must be known.
  void choose_candidates() {
    if (exchange.participates()) {
      interaction.choose_candidates(exchange.known_cells(0),
                                    shape != nullptr ? broad_phase.near_parts() : exchange.known_cells(second ? 1 : 0),
                                    broad_phase.margin());
      keep_nodes_of_candidates();
    }
    if (!exchange.participates() || !interaction.may_touch()) {
      exchange.withdraw();
      interaction.release();
    }
  }

  void keep_nodes_of_candidates() {
    if (second || shape != nullptr) {
      return;  // known_cells() has chosen few enough: of a body that may touch itself, it has all
    }
    std::vector<Index> cells = interaction.cells(0);
    cells.insert(cells.end(), interaction.cells(1).begin(), interaction.cells(1).end());
    exchange.keep_nodes(0, cells);
  }

  void find_overlaps(parallel::Messages& messages) {
    interaction.find_near_pairs();
    portion = exchange.portion(interaction.near_pairs());
    interaction.find_overlaps(portion);
    exchange.send_overlaps(portion, interaction.overlaps(), messages);
  }

  void compute_forces(BondUpdate bonds, const parallel::Messages& messages) {
    exchange.receive_overlaps(portion, interaction.overlaps(), messages);
    interaction.compute_forces(bonds);
    if (exchange.is_reporting_rank()) {
      mean.add(interaction.motion());
    }
  }
};

Contacts::Contacts(const scene::Solids& solids, const mesh::Part& part, const ContactSurfaces& contact_surfaces,
                   double step, int steps_per_update, MPI_Comm communicator)
    : communicator_(communicator), steps_per_update_(steps_per_update) {
  for (std::size_t c = 0; c < solids.contacts.size(); ++c) {
    pairs_.push_back(std::make_unique<Pair>(solids.contacts[c], contact_surfaces.stiffness[c], part, contact_surfaces,
                                            step, steps_per_update, communicator));
  }
}

Contacts::~Contacts() = default;

void Contacts::compute_forces(std::int64_t step_number, std::span<const solid::NodeState> state, BondUpdate bonds) {
  if (pairs_.empty()) {
    return;
  }
  const double start = parallel::wall_time();
  parallel::Messages messages(communicator_);
  if (bonds == BondUpdate::keep) {
    std::ranges::for_each(pairs_, [&](const auto& pair) { pair->next_update = step_number; });
  }
  if (step_number % steps_per_update_ == 0 || bonds == BondUpdate::keep) {
    update_broad_phase(step_number, state, messages);
  } else {
    exchange_states(state, messages);
  }
  // Other ranks wait for the overlaps of shared contacts: these come first, and this rank's own contacts while they
  // travel.
  for (Pair* pair : shared_) {
    pair->find_overlaps(messages);
  }
  for (Pair* pair : own_) {
    pair->find_overlaps(messages);
    pair->compute_forces(bonds, messages);
  }
  for (Pair* pair : shared_) {
    pair->compute_forces(bonds, messages);
  }
  seconds_ += parallel::wall_time() - start;
}

bool Contacts::needs_all_states(std::int64_t step_number) const {
  return step_number % steps_per_update_ == 0 &&
         std::ranges::any_of(pairs_, [&](const auto& pair) { return pair->next_update <= step_number; });
}

void Contacts::update_broad_phase(std::int64_t step_number, std::span<const solid::NodeState> state,
                                  parallel::Messages& messages) {
  std::vector<Pair*> due;
  for (const auto& pair : pairs_) {
    pair->motion = pair->mean.take();
    if (pair->next_update <= step_number) {
      due.push_back(pair.get());
      pair->exchange.send_bounds(state, messages);
    }
  }
  for (Pair* pair : due) {
    pair->exchange.receive_bounds(pair->broad_phase, messages);
    pair->next_update = step_number + std::int64_t{steps_per_update_} * (1 + pair->broad_phase.updates_to_skip());
  }
  for (Pair* pair : due) {
    pair->exchange.receive_nodes(messages);
  }
  find_participations();
  exchange_states(state, messages);
  for (Pair* pair : due) {
    pair->choose_candidates();
  }
  find_participations();
}

void Contacts::find_participations() {
  shared_.clear();
  own_.clear();
  for (const auto& pair : pairs_) {
    if (pair->exchange.participates()) {
      (pair->exchange.is_shared() ? shared_ : own_).push_back(pair.get());
    }
  }
}

void Contacts::exchange_states(std::span<const solid::NodeState> state, parallel::Messages& messages) {
  for (Pair* pair : shared_) {
    pair->exchange.send_states(state, messages);
  }
  for (Pair* pair : own_) {
    pair->exchange.send_states(state, messages);
  }
  for (Pair* pair : shared_) {
    pair->exchange.receive_states(messages);
  }
}

void Contacts::add_force(std::span<solid::NodeForce> force) const {
  for (const auto& pair : pairs_) {
    if (!pair->exchange.participates()) {
      continue;
    }
    const std::vector<Side*> sides = pair->sides();
    for (std::size_t s = 0; s < sides.size(); ++s) {
      for (const SkinNode& node : pair->exchange.owned_near(s)) {
        if (sides[s]->touch[node.place].any) {
          for (int i = 0; i < 3; ++i) {
            force[node.node].component[i] += sides[s]->force[node.place][i];
          }
        }
      }
    }
  }
}

std::vector<Index> Contacts::owned_near() const {
  std::vector<Index> nodes;
  for (const auto& pair : pairs_) {
    for (std::size_t s = 0; pair->interaction.may_touch() && s < pair->sides().size(); ++s) {
      std::ranges::transform(pair->exchange.owned_near(s), std::back_inserter(nodes), &SkinNode::node);
    }
  }
  return nodes;
}

double Contacts::energy(std::size_t contact) const {
  return pairs_[contact]->exchange.is_reporting_rank() ? pairs_[contact]->interaction.energy() : 0.0;
}

const ContactMotion& Contacts::motion(std::size_t contact) const {
  return pairs_[contact]->motion;
}

ContactMotion Contacts::now(std::size_t contact) const {
  return pairs_[contact]->exchange.is_reporting_rank() ? pairs_[contact]->interaction.motion() : ContactMotion{};
}

double Contacts::deepest(std::size_t contact) const {
  return pairs_[contact]->interaction.deepest();
}

void Contacts::archive(parallel::Archive& archive, const parallel::Rows& nodes) {
  for (const auto& pair : pairs_) {
    const std::string path = "contact/" + pair->name;
    double deepest = parallel::largest(pair->interaction.deepest(), archive.communicator());
    archive.root(path + "/deepest", deepest);
    pair->interaction.set_deepest(deepest);
    std::vector<Bond*> bonds(nodes.local_rows());  // null at nodes of other bodies, which have zeros in their rows
    pair->for_each_bond([&](Bond& bond, Index node) { bonds[node] = &bond; });
    archive.rows(path + "/bonds", nodes, [&](std::size_t node, parallel::ArchiveRow& row) {
      Bond none;
      (bonds[node] != nullptr ? *bonds[node] : none).archive(row);
    });
  }
}

}  // namespace idiophone::contact

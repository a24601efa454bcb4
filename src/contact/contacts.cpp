#include "idiophone/contact/contacts.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "interaction.hpp"
#include "meeting.hpp"

namespace idiophone::contact {

namespace {

/// Means of a contact's motion over some steps.
class Mean {
 public:
  void add(const ContactMotion& now) {
    const double weight = now.force.norm();
    sum_.force += now.force;
    sum_.overlap += now.overlap;
    sum_.point += weight * now.point;
    sum_.normal += weight * now.normal;
    sum_.slip += weight * now.slip;
    weight_ += weight;
    ++steps_;
  }

  [[nodiscard]] ContactMotion take() {
    ContactMotion mean = sum_;
    if (steps_ > 0) {
      mean.force /= steps_;
      mean.overlap /= steps_;
    }
    if (weight_ > 0) {
      mean.point /= weight_;
      mean.normal.normalize();
      mean.slip /= weight_;
    }
    *this = {};
    return mean;
  }

 private:
  ContactMotion sum_;
  double weight_ = 0.0;  ///< N
  int steps_ = 0;
};

}  // namespace

struct Contacts::Pair {
  Side first;
  std::optional<Side> second;
  Meeting meeting;
  Interaction interaction;
  Mean mean;
  ContactMotion motion;

  Pair(const scene::Contact& contact, double stiffness, const mesh::Part& part, const Partners& partners, double step,
       int steps_per_look, MPI_Comm communicator)
      : first(partners.skins[contact.body]),
        second(contact.other ? std::optional<Side>(partners.skins[*contact.other]) : std::nullopt),
        meeting(first, second ? &*second : nullptr, second ? nullptr : &partners.shapes[*contact.obstacle], part,
                step * steps_per_look, communicator),
        interaction(second ? Interaction(contact, stiffness, step, first, *second)
                           : Interaction(contact, stiffness, step, first, partners.shapes[*contact.obstacle])) {}

  /// Visits the own nodes of both sides.
  template <class Visitor>
  void for_each_own(Visitor visit) {
    for (std::size_t s = 0; s < (second ? 2U : 1U); ++s) {
      for (const Meeting::SkinNode& node : meeting.own(s)) {
        visit(s == 0 ? first : *second, static_cast<std::size_t>(node.place), static_cast<std::size_t>(node.node));
      }
    }
  }

  void look(const solid::NodeState* state) {
    motion = mean.take();
    meeting.look(state);
    if (!meeting.near()) {
      interaction.part();
      return;
    }
    meeting.follow(state);
    interaction.choose_candidates(meeting.cells(0), meeting.cells(1), meeting.margin());
    if (!interaction.may_touch()) {
      interaction.part();
    }
  }
};

Contacts::Contacts(const scene::Scene& scene, const mesh::Part& part, const Partners& partners, double step,
                   int steps_per_look, MPI_Comm communicator)
    : steps_per_look_(steps_per_look) {
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    pairs_.push_back(std::make_unique<Pair>(scene.contacts[c], partners.stiffness[c], part, partners, step,
                                            steps_per_look, communicator));
  }
}

Contacts::~Contacts() = default;

void Contacts::meet(std::int64_t step_number, const solid::NodeState* state, bool moved) {
  if (pairs_.empty()) {
    return;
  }
  const double start = MPI_Wtime();
  for (const auto& pair : pairs_) {
    if (step_number % steps_per_look_ == 0 || !moved) {
      pair->look(state);
    } else if (pair->interaction.may_touch()) {
      pair->meeting.follow(state);
    }
    if (pair->interaction.may_touch()) {
      pair->interaction.act(moved);
      if (pair->meeting.speaks()) {
        pair->mean.add(pair->interaction.motion());
      }
    }
  }
  seconds_ += MPI_Wtime() - start;
}

void Contacts::add_force(solid::NodeForce* force) const {
  for (const auto& pair : pairs_) {
    if (!pair->interaction.may_touch()) {
      continue;
    }
    for (std::size_t s = 0; s < (pair->second ? 2U : 1U); ++s) {
      const Side& side = s == 0 ? pair->first : *pair->second;
      for (const Meeting::SkinNode& node : pair->meeting.own_near(s)) {
        const auto place = static_cast<std::size_t>(node.place);
        if (side.touch[place].any) {
          for (int i = 0; i < 3; ++i) {
            force[node.node].component[i] += side.force[place][i];
          }
        }
      }
    }
  }
}

double Contacts::energy(std::size_t contact) const {
  return pairs_[contact]->meeting.speaks() ? pairs_[contact]->interaction.energy() : 0.0;
}

const ContactMotion& Contacts::motion(std::size_t contact) const {
  return pairs_[contact]->motion;
}

ContactMotion Contacts::now(std::size_t contact) const {
  return pairs_[contact]->meeting.speaks() ? pairs_[contact]->interaction.motion() : ContactMotion{};
}

double Contacts::deepest(std::size_t contact) const {
  return pairs_[contact]->interaction.deepest();
}

std::vector<double> Contacts::save(std::size_t contact, Index owned_nodes) const {
  std::vector<double> rows(bond_width * static_cast<std::size_t>(owned_nodes));
  pairs_[contact]->for_each_own([&](const Side& side, std::size_t place, std::size_t node) {
    std::copy_n(side.bond[place].stretch.begin(), 3, &rows[bond_width * node]);
    rows[bond_width * node + 3] = side.bond[place].sliding;
  });
  return rows;
}

void Contacts::restore(std::size_t contact, std::span<const double> rows, double deepest) {
  pairs_[contact]->for_each_own([&](Side& side, std::size_t place, std::size_t node) {
    side.bond[place] = {Vector3(&rows[bond_width * node]), rows[bond_width * node + 3]};
  });
  pairs_[contact]->interaction.set_deepest(deepest);
}

}  // namespace idiophone::contact

// The contact forces of a result.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "contact_patch.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/drivers/motion_drivers.hpp"
#include "idiophone/run/results/contact_spread.hpp"
#include "motion_rows.hpp"
#include "rigid_track.hpp"

namespace idiophone::drivers {

namespace {

constexpr std::size_t longest_piece = 64;  // rows in which the point of contact stays

/// The force and the place of one contact.
class ContactRecord {
 public:
  /// @param path  of its channels
  ContactRecord(const results::SeriesReader& reader, const std::string& path)
      : force(reader, path + "/force"), point_(reader, path + "/point") {
    if (std::ranges::find(reader.all(), "/" + path + "/spread", &spectra::Series::path) != reader.all().end()) {
      spread_.emplace(reader, path + "/spread");
    }
  }

  [[nodiscard]] bool touches(std::size_t row) const { return force.vector(row) != Vector3::Zero(); }

  /// Where it acts on a body during some rows, in the coordinates of the undeformed body.
  [[nodiscard]] ContactPatch patch(std::size_t begin, std::size_t end, const RigidTrack& track) const {
    MeanPatch mean;
    for (std::size_t row = begin; row < end; ++row) {
      const Eigen::Isometry3d back = track.at(static_cast<double>(row) / force.rate).inverse();
      mean.add({.middle = back * point_.vector(row), .spread = back.linear() * spread(row) * back.linear().transpose()},
               force.vector(row).norm());
    }
    return mean.mean();
  }

  VectorChannel force;

 private:
  [[nodiscard]] Eigen::Matrix3d spread(std::size_t row) const {
    return spread_ ? results::spread_of_row(std::span(spread_->values).subspan(spread_->width * row, spread_->width))
                   : Eigen::Matrix3d::Zero();
  }

  VectorChannel point_;
  std::optional<VectorChannel> spread_;  // results of older programs have none
};

/// Rows of a contact that belong together: from its begin until nothing touched for a while.
struct Touch {
  std::vector<std::pair<std::size_t, std::size_t>> pieces;  // of rows in which the contact touches, [begin, end)
  Strength strength;
};

std::vector<Touch> touches_of(const ContactRecord& contact) {
  std::vector<Touch> touches;
  std::size_t last = 0;  // end of the piece before
  for (std::size_t begin = 0; begin < contact.force.rows(); ++begin) {
    if (!contact.touches(begin)) {
      continue;
    }
    std::size_t end = begin + 1;
    while (end < contact.force.rows() && end - begin < longest_piece && contact.touches(end)) {
      ++end;
    }
    if (touches.empty() || static_cast<double>(begin - last) / contact.force.rate > gap_of_touches) {
      touches.emplace_back();
    }
    touches.back().pieces.emplace_back(begin, end);
    for (std::size_t row = begin; row < end; ++row) {
      add_row(contact.force.vector(row).norm(), contact.force.rate, touches.back().strength);
    }
    last = end;
    begin = end - 1;
  }
  return touches;
}

/// Forces along each axis at the points of the patch, for a piece of a touch.
Excitation excitation_of(const ContactRecord& contact, std::size_t begin, std::size_t end, double sign,
                         const RigidTrack& track, int rate) {
  const double middle = 0.5 * static_cast<double>(begin + end) / contact.force.rate;
  const Eigen::Matrix3d back = track.at(middle).linear().transpose();
  const ContactPatch patch = contact.patch(begin, end, track);
  const std::vector<Vector3> points = patch.points();
  const double part = 1.0 / static_cast<double>(points.size());
  Excitation excitation;
  excitation.place = patch.middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> rows;
    for (std::size_t row = begin; row < end; ++row) {
      rows.push_back(part * (back * contact.force.vector(row))[axis]);
    }
    resonators::PointForce force = force_of_rows(rows, begin, contact.force.rate, rate);
    force.direction = sign * Vector3::Unit(axis);
    for (const Vector3& point : points) {
      force.at = point;
      excitation.forces.push_back(force);
    }
  }
  return excitation;
}

void add_contact(const ContactRecord& contact, double sign, std::size_t body, const RigidTrack& track, int rate,
                 std::vector<Event>& events) {
  for (const Touch& touch : touches_of(contact)) {
    for (const auto& [begin, end] : touch.pieces) {
      Excitation excitation = excitation_of(contact, begin, end, sign, track, rate);
      excitation.strength = touch.strength;
      excitation.begins = begin == touch.pieces.front().first;
      const std::int64_t start = excitation.forces.front().start;
      events.push_back({.start = start, .body = body, .action = std::move(excitation)});
    }
  }
}

/// A contact of the run's deck: the force on the first of the bodies is the one of the channel.
struct DeckContact {
  std::string name;
  std::vector<std::string> bodies;  ///< one or two; obstacles are left out
};

const deck::Node* child_of(const deck::Node& node, const std::string& key) {
  const auto found = std::ranges::find(node.children, key, &deck::Node::key);
  return found == node.children.end() ? nullptr : &*found;
}

std::vector<DeckContact> contacts_of(const results::SeriesReader& reader, const std::string& file) {
  deck::Mistakes mistakes;
  const deck::Node tree = deck::read_tree(reader.deck(), file, reader.overrides(), mistakes);
  mistakes.raise();
  const deck::Node* bodies = child_of(tree, "bodies");
  std::vector<DeckContact> found;
  const deck::Node* contacts = child_of(tree, "contacts");
  if (contacts == nullptr || bodies == nullptr) {
    return found;
  }
  for (const deck::Node& contact : contacts->children) {
    DeckContact& added = found.emplace_back(DeckContact{.name = contact.key, .bodies = {}});
    if (const deck::Node* between = child_of(contact, "between")) {
      for (const deck::Node& name : between->children) {
        if (child_of(*bodies, name.text) != nullptr) {
          added.bodies.push_back(name.text);
        }
      }
    }
  }
  return found;
}

}  // namespace

std::vector<Event> contact_events(const std::filesystem::path& result, const std::vector<StruckBody>& bodies,
                                  int rate) {
  const results::SeriesReader reader(result);
  std::vector<Event> events;
  bool is_any_known = false;
  for (const DeckContact& contact : contacts_of(reader, result.string())) {
    const std::string path = "contacts/" + contact.name;
    for (std::size_t side = 0; side < contact.bodies.size(); ++side) {
      const auto body = std::ranges::find(bodies, contact.bodies[side], &StruckBody::name);
      if (body != bodies.end()) {
        is_any_known = true;
        add_contact(ContactRecord(reader, path), side == 0 ? 1.0 : -1.0,
                    static_cast<std::size_t>(body - bodies.begin()), RigidTrack(reader, *body), rate, events);
      }
    }
  }
  if (!is_any_known) {
    throw std::runtime_error(
        fmt::format("{}: no contact of its deck has one of the bodies that are played", result.string()));
  }
  return events;
}

}  // namespace idiophone::drivers

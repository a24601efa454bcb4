#pragma once
// The forces of one contact between two sides whose positions are known. A node of either skin has the potential
// k V_i^2/(2 A_i), V_i its share of the overlap volume and A_i that of the surface: V_i/A_i is the depth, and the
// pressure k V_i/A_i acts along the partner's normals. (With one potential W(V) for the whole volume the pressure would
// be the same everywhere, and nothing would keep a block that stands on a plate from tilting.) Between two bodies, each
// side's field counts half. Coulomb friction goes through bonds that stretch before they slide: a bond pulls with the
// pressure times its stretch over the largest depth, so all bonds of a side give way at the same stretch. With friction
// with memory, the bonds are bristles (bristles.hpp): each node has a share of the law's stiffness, damping and
// viscosity, that of the load which it carries. So they, too, all give way at the same deflection, and surfaces that
// slip as a whole rub as the law says.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "idiophone/scene/contact_sections.hpp"
#include "idiophone/solids/contact/contact_motion.hpp"
#include "idiophone/solids/contact/contacts.hpp"
#include "near_pairs.hpp"
#include "overlap.hpp"
#include "side.hpp"

namespace idiophone::contact {

/// Which of several equal portions of a contact's overlaps.
struct Portion {
  std::size_t number = 0;  ///< below `count`
  std::size_t count = 1;
};

class Interaction {
 public:
  /// @param stiffness      k, Pa/m
  /// @param step           dt, s
  /// @param first, second  one side twice: a body in contact with itself
  Interaction(const scene::Contact& contact, double stiffness, double step, Side& first, Side& second);
  Interaction(const scene::Contact& contact, double stiffness, double step, Side& first, const RigidShape& second);

  /// As NearPairs::choose_candidates.
  void choose_candidates(const std::vector<Index>& first, const std::vector<Index>& second, double margin) {
    near_pairs_.choose_candidates(first, second, margin);
  }

  /// The cells of these pairs, ascending; parts of the shape, if that is the second partner.
  [[nodiscard]] const std::vector<Index>& cells(std::size_t partner) const { return near_pairs_.cells(partner); }

  /// Whether there is any such pair: if not, nothing can touch, and nothing needs to be known.
  [[nodiscard]] bool may_touch() const { return near_pairs_.any_candidates(); }

  /// Finds the pairs of cells whose boxes overlap where the sides are now. Clears overlaps and forces.
  void find_near_pairs();

  /// How many there are.
  [[nodiscard]] std::size_t near_pairs() const { return near_pairs_.found().size(); }

  /// Computes the overlaps of a portion of these pairs. The portions, one after the other, are all overlaps in order.
  void find_overlaps(const Portion& portion);

  /// Those computed so far.
  [[nodiscard]] Overlaps& overlaps() { return overlaps_; }

  /// Computes forces from the overlaps, which must be complete. Nodes that touch no more lose their bonds.
  void compute_forces(BondUpdate bonds);

  /// Clears overlaps, forces and bonds.
  void release();

  [[nodiscard]] double energy() const;  ///< stored in overlaps and bonds, J
  /// The contact as a whole, now; all zero where nothing touches. Of a body with itself: what acts on the first parts
  /// (parts.hpp).
  [[nodiscard]] ContactMotion motion() const;
  [[nodiscard]] double deepest() const { return deepest_; }  ///< V_i/A over the touching surface, largest so far, m
  void set_deepest(double deepest) { deepest_ = deepest; }

 private:
  void gather_touches();
  void compute_normal_pressure(Side& side);
  void compute_friction(BondUpdate bonds);
  void rub(Side& side, BondUpdate bonds) const;
  /// Friction over pressure, against the motion.
  [[nodiscard]] Vector3 coulomb_pull(const Vector3& slip, const Vector3& normal, double depth, BondUpdate bonds,
                                     Bond& bond) const;
  [[nodiscard]] Vector3 bristle_pull(const Vector3& slip, const Vector3& normal, double share, BondUpdate bonds,
                                     Bond& bond) const;
  [[nodiscard]] double share_of_load(const Touch& touch) const;
  void limit_stretch(const Vector3& slip, double depth, Bond& bond) const;
  void add_nodal_forces();
  [[nodiscard]] double energy_of_bond(const Touch& touch, const Bond& bond) const;
  void clear();
  [[nodiscard]] bool is_with_itself() const { return both_[0] == both_[1]; }
  /// Those that are bodies', each once.
  [[nodiscard]] std::span<Side* const> sides() const {
    return {both_.data(), both_[1] != nullptr && !is_with_itself() ? 2U : 1U};
  }
  [[nodiscard]] Side& side(int which) const { return *both_.at(static_cast<std::size_t>(which)); }
  static Touch& touch_of(Side& side, Index node);

  scene::Friction friction_;
  double damping_;             ///< s
  double stiffness_;           ///< of one side's field, Pa/m
  double step_;                ///< s
  std::array<Side*, 2> both_;  ///< null for an obstacle; one side twice for a body with itself
  const RigidShape* shape_ = nullptr;
  NearPairs near_pairs_;
  Overlaps overlaps_;
  double load_ = 0.0;  ///< of friction with memory: sum of pressure times surface of all nodes, N
  double deepest_ = 0.0;
};

}  // namespace idiophone::contact

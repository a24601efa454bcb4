#pragma once
// What the boundary layers at walls take from the sound: friction of the air that flows along them, and heat that they
// conduct away. Layers are thin compared with cells and with the distances of walls (Kirchhoff's theory).

#include <span>
#include <vector>

#include "face_exchange.hpp"
#include "half_derivative.hpp"
#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/lossy_air.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::waves {

/// Between two nodes, the air moves by u = U/(rho h) times a step. It feels the difference of their pressures g, and
/// friction: dU/dt + P/A sqrt(nu) d^(1/2)U/dt^(1/2) = g, where P is the wall's area over the length of the way, A its
/// section, nu the viscosity. The air of a node is softer by what its walls keep at their temperature:
/// dp/dt + W/V (gamma - 1) sqrt(alpha) d^(1/2)p/dt^(1/2) = rate, where W is the wall's area, V the node's volume, alpha
/// the diffusivity of heat (Pierce 1989, "Acoustics", section 10-4).
class WallLosses {
 public:
  /// Between a node of the subdomain and another one.
  struct Way {
    Index node, other;
    float weight;  ///< of its flow in the node's rate: C^2 A/V
  };

  /// Collective.
  /// @param cut_cells  with walls
  /// @param courant    c dt/h
  /// @param exchange   of these nodes
  WallLosses(const Subdomain& subdomain, const CutCells& cut_cells, const LossyAir& air, double courant,
             const FaceExchange& exchange);

  /// Takes from the rates of the nodes what friction takes in the next step.
  /// @param pressure  [cells, then nodes] Pa
  /// @param rate      [nodes] Pa per step
  void slow(std::span<const float> pressure, std::span<float> rate);
  /// Takes heat, likewise.
  void cool(std::span<const float> pressure, std::span<float> rate);
  /// Goes on by the step that slow() and cool() were asked about last.
  void advance();

  /// The air comes to rest at these walls.
  /// @param pressure  [cells, then nodes] Pa
  void rest(std::span<const float> pressure);
  /// Takes the past of walls before, where air was in the same cells. The rest is as in rest().
  void take_past(const CutCells& cut_cells, const WallLosses& before, const CutCells& cut_cells_before);

  /// @param cut_cells  as at the beginning
  void archive(const CutCells& cut_cells, parallel::Archive& archive);

  // For an accelerator:
  [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }        ///< by node
  [[nodiscard]] const std::vector<Index>& cooled() const { return cooled_; }  ///< nodes at walls, ascending
  [[nodiscard]] const HalfDerivative& friction() const { return friction_; }  ///< of the ways
  [[nodiscard]] HalfDerivative& friction() { return friction_; }
  [[nodiscard]] const HalfDerivative& heat() const { return heat_; }  ///< of the cooled nodes
  [[nodiscard]] HalfDerivative& heat() { return heat_; }
  [[nodiscard]] const std::vector<float>& flow() const { return flow_; }  ///< [friction().length()] U, Pa
  [[nodiscard]] std::vector<float>& flow() { return flow_; }

 private:
  /// Places in ways_ and cooled_; -1 for none.
  [[nodiscard]] Index find_way(Index node, Index other) const;
  [[nodiscard]] Index find_cooled(Index node) const;

  Subdomain subdomain_;
  std::vector<Way> ways_;      // by node
  std::vector<Index> cooled_;  // nodes at walls, ascending
  HalfDerivative friction_, heat_;
  std::vector<float> flow_, push_, slowed_;    // [ways] U, its gain without friction, what friction takes, Pa
  std::vector<float> pressure_, gain_, lost_;  // [cooled nodes] p, its gain without heat, what heat takes, Pa
};

}  // namespace idiophone::waves

// The motion of columns with added mass, a pack at a time.

#include <cmath>

#include "idiophone/solids/solid/added_mass.hpp"
#include "node_lines.hpp"

namespace idiophone::solid {

namespace {

/// A vector for each column of a pack.
using PackVector = Pack[3];

Pack dot(const PackVector& a, const PackVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Pack root(const Pack& square) {
  Pack result;
  for (int lane = 0; lane < lanes; ++lane) {
    result[lane] = std::sqrt(square[lane]);
  }
  return result;
}

/// Adds one node's share to a vector of each shape.
/// @param value  of the nodes, three components
inline void add_weighted(const Pack (&weight)[2], const Pack* value, PackVector (&sum)[2]) {
  for (int s = 0; s < 2; ++s) {
    for (int i = 0; i < 3; ++i) {
      sum[s][i] += weight[s] * value[i];
    }
  }
}

/// Where the columns of a pack are now, from the vectors D of each shape.
struct Pose {
  explicit Pose(const PackVector (&spread)[2]) : length(root(dot(spread[0], spread[0]))), inverse_length(1.0 / length) {
    for (int i = 0; i < 3; ++i) {
      director[i] = spread[0][i] * inverse_length;
    }
    bow = dot(director, spread[1]);
    for (int i = 0; i < 3; ++i) {
      lean[i] = (spread[1][i] - bow * director[i]) * inverse_length;
    }
  }

  Pack length;          ///< L = |D_linear|, kg^1/2 m
  Pack inverse_length;  ///< 1/L
  PackVector director;  ///< n
  PackVector lean;      ///< the part of D_quadratic at right angles to n, over |D_linear|
  Pack bow;             ///< B = n . D_quadratic, kg^1/2 m
};

}  // namespace

/// What the nodes of a pack of columns add up to: D, D', and the D'' that they would have without added mass.
struct AddedMass::Sums {
  PackVector spread[2];
  PackVector rate[2] = {};
  PackVector pull[2] = {};

  explicit Sums(const ColumnPack& pack) {
    for (int s = 0; s < 2; ++s) {
      std::copy(pack.spread[s], pack.spread[s] + 3, spread[s]);
    }
  }
};

// Lagrange's equations of the added energies, for the acceleration A of each D and the force F on it, which is the
// acceleration that it would have without them:
//   (1 + b_1) A_1 = F_1 - p_1 n - p_2 lean,  p_1 = c_1 L'',  L'' = n . A_1 + L w^2,
//   (1 + b_2) A_2 = F_2 - p_2 n,  p_2 = c_2 B'',  B'' = n . A_2 + lean . A_1 + 2 n' . D_2' - 2 L'/L n' . D_2 - w^2 B,
// with w = |n'|.
void AddedMass::find_change(const ColumnPack& pack, const Sums& sums, double age, Pack (&change)[2][3]) {
  const Pose pose(sums.spread);
  const auto& pull = sums.pull;
  const Pack& first = pack.compliance[0];
  const Pack& second = pack.compliance[1];
  const Pack by_force = first * dot(pose.director, pull[0]);
  const Pack bend_by_force = second * dot(pose.director, pull[1]) + first * dot(pose.lean, pull[0]);
  const Pack factor_1 = pack.along[0] / (1.0 + pack.along[0] * first);
  const Pack factor_2 = pack.along[1] / (1.0 + pack.along[1] * (second + first * dot(pose.lean, pose.lean)));
  const auto find = [&](const PackVector(&rate)[2]) {
    const Pack stretching = dot(pose.director, rate[0]);
    PackVector turning;  // n'
    for (int i = 0; i < 3; ++i) {
      turning[i] = (rate[0][i] - stretching * pose.director[i]) * pose.inverse_length;
    }
    const Pack square = dot(turning, turning);
    const Pack p_1 = factor_1 * (by_force + pose.length * square);
    const Pack p_2 = factor_2 * (bend_by_force + 2.0 * dot(turning, rate[1]) -
                                 2.0 * stretching * dot(turning, pose.lean) - square * pose.bow);
    for (int i = 0; i < 3; ++i) {
      change[0][i] = first * (pull[0][i] - p_1 * pose.director[i] - p_2 * pose.lean[i]) - pull[0][i];
      change[1][i] = second * (pull[1][i] - p_2 * pose.director[i]) - pull[1][i];
    }
  };
  find(sums.rate);
  PackVector rate_now[2];  // so that the scheme is of second order
  for (int s = 0; s < 2; ++s) {
    for (int i = 0; i < 3; ++i) {
      rate_now[s][i] = sums.rate[s][i] + age * (pull[s][i] + change[s][i]);
    }
  }
  find(rate_now);
}

void AddedMass::reduce_to_lumped(std::span<const NodeState> state, double age, std::span<NodeForce> force) const {
  PackVector forces[most_levels + 1];
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const std::span<const Level> level = levels(number);
    Sums sums(packs_[number]);
    for (std::size_t k = 0; k < levels_; ++k) {
      Pack rows[line_length];
      gather_node(state.data(), level[k].node, rows);
      add_weighted(level[k].weight, &rows[0], sums.spread);
      add_weighted(level[k].weight, &rows[3], sums.rate);
    }
    for (std::size_t k = 0; k < levels_; k += 2) {
      gather_forces(force.data(), level[k].node, level[std::min(k + 1, levels_ - 1)].node, forces[k], forces[k + 1]);
    }
    for (std::size_t k = 0; k < levels_; ++k) {
      const PackVector acceleration = {level[k].inverse_mass * forces[k][0], level[k].inverse_mass * forces[k][1],
                                       level[k].inverse_mass * forces[k][2]};
      add_weighted(level[k].weight, acceleration, sums.pull);
    }
    PackVector change[2];
    find_change(packs_[number], sums, age, change);
    for (std::size_t k = 0; k < levels_; ++k) {
      for (int i = 0; i < 3; ++i) {
        forces[k][i] += level[k].weight[0] * change[0][i] + level[k].weight[1] * change[1][i];
      }
    }
    put_forces(number, forces, force);
  }
}

void AddedMass::put_forces(std::size_t pack, const Pack (*forces)[3], std::span<NodeForce> force) const {
  const std::span<const Level> level = levels(pack);
  ForceLine lines[lanes][most_levels + 1];
  for (std::size_t k = 0; k < levels_; k += 2) {
    put_lines(forces[k], forces[std::min(k + 1, levels_ - 1)], lines, k);
  }
  for (int lane = 0; lane < filled_lanes(pack); ++lane) {
    for (std::size_t k = 0; k < levels_; ++k) {
      std::memcpy(force[level[k].node[lane]].component, &lines[lane][k], sizeof(ForceLine));
    }
  }
}

/// D of each shape.
auto AddedMass::sums_of_positions(std::size_t pack, std::span<const NodeState> state) const -> Sums {
  Sums sums(packs_[pack]);
  for (const Level& level : levels(pack)) {
    Pack rows[line_length];
    gather_node(state.data(), level.node, rows);
    add_weighted(level.weight, &rows[0], sums.spread);
  }
  return sums;
}

void AddedMass::add_momentum(std::span<const NodeState> state, std::span<const Vector3> velocity,
                             std::span<Vector3> momentum) const {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const ColumnPack& pack = packs_[number];
    Sums sums = sums_of_positions(number, state);
    for (const Level& level : levels(number)) {
      PackVector moving;
      for (int i = 0; i < 3; ++i) {
        for (int lane = 0; lane < lanes; ++lane) {
          moving[i][lane] = velocity[level.node[lane]][i];
        }
      }
      add_weighted(level.weight, moving, sums.rate);
    }
    const Pose pose(sums.spread);
    const Pack stretching = pack.along[0] * dot(pose.director, sums.rate[0]);
    const Pack bowing = pack.along[1] * (dot(pose.director, sums.rate[1]) + dot(pose.lean, sums.rate[0]));
    for (const Level& level : levels(number)) {
      for (int i = 0; i < 3; ++i) {
        const Pack linear = pack.isotropic[0] * sums.rate[0][i] + stretching * pose.director[i] + bowing * pose.lean[i];
        const Pack quadratic = pack.isotropic[1] * sums.rate[1][i] + bowing * pose.director[i];
        const Pack added = level.weight[0] * linear + level.weight[1] * quadratic;
        for (int lane = 0; lane < filled_lanes(number); ++lane) {
          momentum[level.node[lane] - begin_][i] += added[lane];
        }
      }
    }
  }
}

std::vector<Eigen::Matrix3d> AddedMass::second_moments(std::span<const NodeState> state) const {
  std::vector<Eigen::Matrix3d> moments;
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const Sums sums = sums_of_positions(number, state);
    for (int lane = 0; lane < filled_lanes(number); ++lane) {
      Eigen::Matrix3d& moment = moments.emplace_back(Eigen::Matrix3d::Zero());
      for (int s = 0; s < 2; ++s) {
        const Vector3 spread(sums.spread[s][0][lane], sums.spread[s][1][lane], sums.spread[s][2][lane]);
        moment += packs_[number].isotropic[s][lane] * spread * spread.transpose();
      }
    }
  }
  return moments;
}

}  // namespace idiophone::solid

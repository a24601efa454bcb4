#include "idiophone/solids/solid/added_mass.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace idiophone::solid {

namespace {

/// The lines of nodes through the thickness of all elements, each once, nodes from one face to the other.
std::vector<std::vector<Index>> find_columns(const mesh::BodyPart& body) {
  const int in_plane = (body.element.plane + 1) * (body.element.plane + 1);
  std::vector<std::vector<Index>> columns;
  std::vector<std::ptrdiff_t> column_of;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    const auto nodes = body.element_nodes(e);
    for (int line = 0; line < in_plane; ++line) {
      std::vector<Index> column;
      for (int k = 0; k <= body.element.thickness; ++k) {
        column.push_back(nodes[line + in_plane * k]);
      }
      const Index largest = *std::ranges::max_element(column);
      if (largest >= std::ssize(column_of)) {
        column_of.resize(largest + 1, -1);
      }
      const std::ptrdiff_t known = column_of[column.front()];
      if (std::ranges::any_of(column, [&](Index node) { return column_of[node] != known; })) {
        throw std::runtime_error(
            fmt::format("mass_scaling needs one layer of hexahedra through the thickness, all with their third "
                        "direction across it: element {} shares a part of a column of nodes with another",
                        body.element_ids[e]));
      }
      if (known < 0) {
        for (const Index node : column) {
          column_of[node] = std::ssize(columns);
        }
        columns.push_back(std::move(column));
      }
    }
  }
  return columns;
}

}  // namespace

AddedMass::AddedMass(const mesh::BodyPart& body, std::span<const Vector3> reference, std::span<const double> lumped,
                     std::span<const Index> held, const std::function<MassScaling(double)>& scaling)
    : begin_(body.owned_begin), levels_(body.element.thickness + 1) {
  const auto is_owned = [&](Index node) { return node >= body.owned_begin && node < body.owned_end; };
  const auto is_held = [&](Index node) {
    return std::ranges::binary_search(held, 3 * node) && std::ranges::binary_search(held, 3 * node + 1) &&
           std::ranges::binary_search(held, 3 * node + 2);
  };
  for (const std::vector<Index>& nodes : find_columns(body)) {
    if (std::ranges::all_of(nodes, is_owned) && !std::ranges::all_of(nodes, is_held)) {
      std::vector<double> masses;
      std::ranges::transform(nodes, std::back_inserter(masses), [&](Index node) { return lumped[node - begin_]; });
      const Column column = make_column(nodes, reference, masses, scaling);
      add_held(column_count_, column, held);
      add(column);
    }
  }
}

AddedMass::Column AddedMass::make_column(std::span<const Index> nodes, std::span<const Vector3> reference,
                                         std::span<const double> masses,
                                         const std::function<MassScaling(double)>& scaling) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  const Vector3 across = reference[nodes.back()] - reference[nodes.front()];
  const Eigen::Map<const Eigen::VectorXd> mass(masses.data(), count);
  Eigen::VectorXd height(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    height[i] = (reference[nodes[i]] - reference[nodes.front()]).dot(across.normalized());
  }
  const auto product = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (mass.array() * a.array() * b.array()).sum();
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(count);
  const Eigen::VectorXd linear = height - product(one, height) / product(one, one) * one;
  Eigen::VectorXd quadratic = linear.array().square();
  quadratic -=
      product(one, quadratic) / product(one, one) * one + product(linear, quadratic) / product(linear, linear) * linear;
  const std::array<Eigen::VectorXd, 2> shapes = {linear / std::sqrt(product(linear, linear)),
                                                 quadratic / std::sqrt(product(quadratic, quadratic))};
  const MassScaling factor = scaling(across.norm());
  Column column{.members = {},
                .spread = {Vector3::Zero(), Vector3::Zero()},
                .isotropic = {factor.rotation, factor.plane_bow},
                .along = {factor.stretch - factor.rotation, factor.bow - factor.plane_bow}};
  for (Eigen::Index i = 0; i < count; ++i) {
    const ColumnNode& member = column.members.emplace_back(
        ColumnNode{nodes[i], 1 / mass[i], {mass[i] * shapes[0][i], mass[i] * shapes[1][i]}});
    for (std::size_t s = 0; s < 2; ++s) {
      // Measured from one of the nodes: the weights add up to zero.
      column.spread[s] += member.weight[s] * (reference[nodes[i]] - reference[nodes.front()]);
    }
  }
  return column;
}

void AddedMass::add(const Column& column) {
  const std::size_t first = column_count_ % lanes;
  if (first == 0) {
    packs_.emplace_back();
    level_.resize(level_.size() + levels_);
  }
  ColumnPack& pack = packs_.back();
  Level* const level = &level_[level_.size() - levels_];
  for (std::size_t lane = first; lane < lanes; ++lane) {
    for (std::size_t s = 0; s < 2; ++s) {
      for (int i = 0; i < 3; ++i) {
        pack.spread[s][i][lane] = column.spread[s][i];
      }
      pack.isotropic[s][lane] = column.isotropic[s];
      pack.compliance[s][lane] = 1 / (1 + column.isotropic[s]);
      pack.along[s][lane] = column.along[s];
      for (std::size_t k = 0; k < levels_; ++k) {
        level[k].weight[s][lane] = column.members[k].weight[s];
      }
    }
    for (std::size_t k = 0; k < levels_; ++k) {
      level[k].inverse_mass[lane] = column.members[k].inverse_mass;
      level[k].node[lane] = column.members[k].node;
    }
  }
  ++column_count_;
}

AddedMass::Column AddedMass::at(std::size_t column) const {
  const ColumnPack& pack = packs_[column / lanes];
  const std::size_t lane = column % lanes;
  Column result;
  for (std::size_t s = 0; s < 2; ++s) {
    result.spread[s] = {pack.spread[s][0][lane], pack.spread[s][1][lane], pack.spread[s][2][lane]};
    result.isotropic[s] = pack.isotropic[s][lane];
    result.along[s] = pack.along[s][lane];
  }
  for (const Level& level : levels(column / lanes)) {
    result.members.push_back(
        {level.node[lane], level.inverse_mass[lane], {level.weight[0][lane], level.weight[1][lane]}});
  }
  return result;
}

void AddedMass::apply_inverse_root(std::span<double> x) const {
  const auto part = [](double added) { return 1 - 1 / std::sqrt(1 + added); };
  for (std::size_t c = 0; c < column_count_; ++c) {
    if (const auto held = held_.find(c); held != held_.end()) {
      apply_held_root(held->second, x);
      continue;
    }
    const Column column = at(c);
    const Vector3 director = column.spread[0].normalized();
    std::array<Vector3, 2> change = {Vector3::Zero(), Vector3::Zero()};
    for (std::size_t s = 0; s < 2; ++s) {
      for (const ColumnNode& member : column.members) {
        const Eigen::Map<const Vector3> at(&x[3 * static_cast<std::size_t>(member.node - begin_)]);
        change[s] += member.weight[s] * std::sqrt(member.inverse_mass) * at;
      }
      const double across = part(column.isotropic[s]);
      const double along = part(column.isotropic[s] + column.along[s]);
      change[s] = across * change[s] + (along - across) * director.dot(change[s]) * director;
    }
    for (const ColumnNode& member : column.members) {
      Eigen::Map<Vector3>(&x[3 * static_cast<std::size_t>(member.node - begin_)]) -=
          std::sqrt(member.inverse_mass) * (member.weight[0] * change[0] + member.weight[1] * change[1]);
    }
  }
}

Eigen::Matrix3d AddedMass::entries(const Column& column, const ColumnNode& row, const ColumnNode& other) {
  const Vector3 director = column.spread[0].normalized();
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  for (std::size_t s = 0; s < 2; ++s) {
    block += row.weight[s] * other.weight[s] *
             (column.isotropic[s] * Eigen::Matrix3d::Identity() + column.along[s] * director * director.transpose());
  }
  return block;
}

}  // namespace idiophone::solid

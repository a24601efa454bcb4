#include "idiophone/air/waves/cut_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "cell_parts.hpp"
#include "solid_voxels.hpp"
#include "wall_shares.hpp"

namespace idiophone::waves {

namespace {

constexpr float face_bits = 64.0F;

std::array<int, 3> neighbour(std::array<int, 3> cell, int face) {
  cell.at(face / 2) += face % 2 == 0 ? -1 : 1;
  return cell;
}

constexpr int opposite(int face) {
  return face % 2 == 0 ? face + 1 : face - 1;
}

}  // namespace

/// Makes the nodes, then their links.
class CutCells::Builder {
 public:
  Builder(CutCells& cells, const Obstruction& obstruction, double courant, bool with_walls)
      : cells_(cells),
        subdomain_(cells.subdomain_),
        voxels_(subdomain_, obstruction),
        least_volume_(static_cast<float>(least_volume(courant))),
        with_walls_(with_walls) {
    for (const Mask& mask : voxels_.masks()) {
      parts_.push_back(parts_of(mask));
    }
  }

  void build() {
    cells_.box_ = voxels_.box();
    cells_.contents_.assign(cells_.box_.size(), SolidVoxels::air);
    add_nodes(true);
    cells_.own_nodes_ = static_cast<Index>(cells_.nodes_.size());
    add_nodes(false);
    add_links();
  }

 private:
  /// @param own  of the subdomain's cells; otherwise of its ghost cells
  void add_nodes(bool own) {
    for_each_cell(common(voxels_.box(), subdomain_.cells().grown(1)), [&](const std::array<int, 3>& cell) {
      if (subdomain_.owns(cell) == own) {
        add_nodes_of(cell);
      }
    });
  }

  void add_nodes_of(const std::array<int, 3>& cell) {
    const Index content = voxels_.content(cell);
    Index& place = cells_.contents_[voxels_.box().place(cell)];
    if (content == SolidVoxels::solid) {
      place = SolidVoxels::solid;
      add_solid(cell);
    } else if (content >= 0) {
      place = static_cast<Index>(nodes_parts_.size());
      for (const Part& part : parts_[content]) {
        add_node(cell, part);
      }
    } else if (is_near_surface(cell)) {
      place = static_cast<Index>(nodes_parts_.size());
      add_node(cell, open_cell);
    }
  }

  void add_node(const std::array<int, 3>& cell, const Part& part) {
    nodes_parts_.push_back(&part);
    cells_.nodes_.push_back({cell, part.mask, static_cast<float>(count(part.mask)) / (face_bits * voxels)});
  }

  void add_solid(const std::array<int, 3>& cell) {
    const Index number = subdomain_.number(cell);
    auto& solids = cells_.solids_;
    if (!solids.empty() && solids.back().first + solids.back().length == number) {
      ++solids.back().length;
    } else {
      solids.push_back({number, 1});
    }
  }

  /// Whether a cell full of air has a neighbour that is not simply as open as itself. With walls, any cut cell is one:
  /// friction slows the flow between nodes only.
  [[nodiscard]] bool is_near_surface(const std::array<int, 3>& cell) const {
    for (int face = 0; face < faces; ++face) {
      const Index content = voxels_.content(neighbour(cell, face));
      if (content == SolidVoxels::solid) {
        return true;
      }
      if (content >= 0 &&
          (with_walls_ || parts_[content].size() != 1 || parts_[content][0].open.at(opposite(face)) != all_bits)) {
        return true;
      }
    }
    return false;
  }

  void add_links() {
    cells_.first_link_.reserve(cells_.nodes_.size() + 1);
    for (std::size_t node = 0; node < cells_.nodes_.size(); ++node) {
      cells_.first_link_.push_back(static_cast<Index>(cells_.links_.size()));
      if (node < static_cast<std::size_t>(cells_.own_nodes_)) {
        add_links_of(node);
      }
    }
    cells_.first_link_.push_back(static_cast<Index>(cells_.links_.size()));
  }

  void add_links_of(std::size_t number) {
    Node& node = cells_.nodes_[number];
    float areas = 0.0F;
    for (int face = 0; face < faces; ++face) {
      const auto next = neighbour(node.cell, face);
      if (next[2] < 0 && subdomain_.grid().rigid_below) {
        continue;
      }
      const std::uint64_t open = nodes_parts_[number]->open.at(face);
      const auto [first, last] = cells_.nodes_of(next);
      for (Index other = first; other < last; ++other) {
        const Part& part = *nodes_parts_[other];
        areas += add_link(subdomain_.length() + other, open & part.open.at(opposite(face)),
                          way_between(*nodes_parts_[number], part, face));
      }
      if (first == last && !cells_.is_solid(next)) {
        areas += add_link(subdomain_.number(next), open);
      }
    }
    const Part& part = *nodes_parts_[number];
    if (part.opening > 0.0F) {
      cells_.links_.push_back({subdomain_.length() + cells_.nodes_of(node.cell).first + part.twin, part.opening});
      areas += part.opening;
    }
    node.volume = std::max(node.volume, least_volume_ * areas);
  }

  /// @param way  see way_between
  /// @return the open area, over that of a face
  float add_link(Index to, std::uint64_t open, float way = 1.0F) {
    const float area = static_cast<float>(std::popcount(open)) / face_bits;
    if (open != 0) {
      cells_.links_.push_back({to, open == all_bits ? area : area * narrowing(way)});
    }
    return area;
  }

  /// A part has one pressure, so the way around an edge of a solid inside of a cell would be too easy. The third power
  /// is fitted to bars (docs/method/waves.md).
  static float narrowing(float way) { return way > 1.0F ? 1.0F / (way * way * way) : 1.0F; }

  CutCells& cells_;
  Subdomain subdomain_;
  SolidVoxels voxels_;
  float least_volume_;  // of a node, over its open areas
  bool with_walls_;
  std::vector<std::vector<Part>> parts_;  // of each cut cell
  std::vector<const Part*> nodes_parts_;  // of each node
};

CutCells::CutCells(const Subdomain& subdomain) : subdomain_(subdomain), first_link_(1) {}

CutCells::CutCells(const Subdomain& subdomain, const Obstruction& obstruction, double courant, bool with_walls)
    : CutCells(subdomain) {
  first_link_.clear();
  Builder(*this, obstruction, courant, with_walls).build();
  if (with_walls) {
    walls_ = wall_shares(subdomain, obstruction, *this);
  }
}

Index CutCells::content(const std::array<int, 3>& cell) const {
  return box_.contains(cell) ? contents_[box_.place(cell)] : Index{SolidVoxels::air};
}

std::pair<Index, Index> CutCells::nodes_of(const std::array<int, 3>& cell) const {
  const Index first = content(cell);
  if (first < 0) {
    return {0, 0};
  }
  Index last = first;
  while (last < static_cast<Index>(nodes_.size()) && nodes_[last].cell == cell) {
    ++last;
  }
  return {first, last};
}

bool CutCells::is_solid(const std::array<int, 3>& cell) const {
  return content(cell) == SolidVoxels::solid;
}

Index CutCells::node_at(const Vector3& in_cells) const {
  const std::array<int, 3> cell = cell_at(in_cells);
  std::array<int, 3> voxel{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    voxel.at(axis) = std::clamp(static_cast<int>((in_cells[axis] - cell.at(axis)) * voxels), 0, voxels - 1);
  }
  const auto [first, last] = nodes_of(cell);
  for (Index node = first; node < last; ++node) {
    if (contains(nodes_[node].mask, voxel)) {
      return node;
    }
  }
  return -1;
}

}  // namespace idiophone::waves

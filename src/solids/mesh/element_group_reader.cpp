#include "element_group_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "compressed_rows.hpp"
#include "element_reader.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"
#include "list_reader.hpp"
#include "mesh_file_paths.hpp"
#include "together.hpp"

namespace idiophone::mesh {

namespace {

/// The number of a group and of an element in it.
using GroupMember = std::array<Index, 2>;

/// A range of the members of all groups, one after the other.
struct MemberRows {
  ListOutline lists;
  Index begin = 0;             ///< of the range
  std::vector<Index> members;  ///< [range] elements
  Index before = -1;           ///< the member before the range; -1 for none
  std::int64_t promised = 0;   ///< checksum of all members

  /// The group of a member of the range.
  [[nodiscard]] Index group_of(std::size_t place) const {
    const Index row = begin + static_cast<Index>(place);
    return static_cast<Index>(std::ranges::upper_bound(lists.begins, row) - lists.begins.begin()) - 1;
  }
};

/// @throws std::runtime_error unless the elements of each list ascend
void require_ascending(const MemberRows& rows) {
  Index before = rows.before;
  for (std::size_t place = 0; place < rows.members.size(); ++place) {
    const bool is_first = std::ranges::binary_search(rows.lists.begins, rows.begin + static_cast<Index>(place));
    if (!is_first && rows.members[place] <= before) {
      refuse_table(mesh_file::element_groups,
                   fmt::format("has the list '{}', which does not ascend", rows.lists.names[rows.group_of(place)]));
    }
    before = rows.members[place];
  }
}

MemberRows read_members(const MeshTables& tables, int rank, int ranks) {
  const std::string path = std::string(mesh_file::element_groups) + mesh_file::members;
  MemberRows rows{.lists = read_list_outline(tables, mesh_file::element_groups, 1), .members = {}};
  const Index count = rows.lists.begins.back();
  rows.begin = first_row(count, rank, ranks);
  rows.members = tables.read_rows<Index, Index>(path, 1, rows.begin, first_row(count, rank + 1, ranks));
  rows.promised = tables.checksum(path);
  const auto before = tables.read_rows<Index, Index>(path, 1, std::max(rows.begin - 1, 0), rows.begin);
  rows.before = before.empty() ? -1 : before.front();
  return rows;
}

/// To the ranks in whose ranges the elements are. Collective.
std::vector<GroupMember> exchanged(const MemberRows& rows, Index element_count, MPI_Comm communicator) {
  const int ranks = parallel::size_of(communicator);
  std::vector<Index> begins(ranks);
  for (int rank = 0; rank < ranks; ++rank) {
    begins[rank] = first_row(element_count, rank, ranks);
  }
  const CompressedRows takers(ranks, [&](auto take) {
    for (std::size_t place = 0; place < rows.members.size(); ++place) {
      const auto after = std::ranges::upper_bound(begins, rows.members[place]);
      take(static_cast<Index>(after - begins.begin()) - 1, static_cast<Index>(place));
    }
  });
  std::vector<int> counts;
  std::vector<GroupMember> sent;
  for (int rank = 0; rank < ranks; ++rank) {
    counts.push_back(static_cast<int>(takers[rank].size()));
    for (const Index place : takers[rank]) {
      sent.push_back({rows.group_of(static_cast<std::size_t>(place)), rows.members[place]});
    }
  }
  return parallel::exchange<GroupMember>(sent, counts, communicator);
}

}  // namespace

std::map<std::string, std::vector<std::size_t>> read_element_groups(const scene::Body& body, Index element_count,
                                                                    MPI_Comm communicator) {
  MemberRows rows;
  read_together(body, communicator, [&] {
    rows = read_members(MeshTables(body.mesh), parallel::rank_of(communicator), parallel::size_of(communicator));
  });
  const std::uint32_t found = files::checksum_of_blocks(std::as_bytes(std::span(rows.members)), communicator);
  read_together(body, communicator, [&] {
    require_checksum(std::string(mesh_file::element_groups) + mesh_file::members, rows.promised, found);
    require_ascending(rows);
    require_numbers(mesh_file::element_groups, rows.members, static_cast<std::size_t>(element_count));
  });
  const std::vector<GroupMember> members = exchanged(rows, element_count, communicator);
  std::map<std::string, std::vector<std::size_t>> groups;
  for (const std::string& name : rows.lists.names) {
    groups[name];
  }
  for (const auto& [group, element] : members) {
    groups[rows.lists.names[group]].push_back(static_cast<std::size_t>(element));
  }
  return groups;
}

}  // namespace idiophone::mesh

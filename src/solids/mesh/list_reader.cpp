#include "list_reader.hpp"

#include <algorithm>
#include <set>

#include "idiophone/files/attributes.hpp"
#include "mesh_file_paths.hpp"

namespace idiophone::mesh {

ListOutline read_list_outline(const MeshTables& tables, const std::string& group, int width) {
  ListOutline lists{.names = hdf5::texts_in(tables.file(), group + mesh_file::names),
                    .begins = tables.read<Index, Index>(group + mesh_file::begins, 1)};
  const auto& [names, begins] = lists;
  if (begins.size() != names.size() + 1 || begins.front() != 0 || !std::ranges::is_sorted(begins) ||
      begins.back() != tables.rows(group + mesh_file::members, width)) {
    refuse_table(group, "has lists that do not fit their names");
  }
  if (std::set(names.begin(), names.end()).size() != names.size()) {
    refuse_table(group, "has two lists of one name");
  }
  return lists;
}

}  // namespace idiophone::mesh

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "hash.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "list_reader.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_outline.hpp"
#include "mesh_table_reader.hpp"

namespace idiophone::mesh {

namespace {

void require_finite(const std::vector<Vector3>& nodes) {
  const auto wrong = std::ranges::find_if(nodes, [](const Vector3& node) { return !node.allFinite(); });
  if (wrong != nodes.end()) {
    refuse_table(mesh_file::nodes,
                 fmt::format("has node {} at {}, which isn't a place", wrong - nodes.begin(), to_text(*wrong)));
  }
}

/// Lists as mesh.group_triangles.
/// @throws std::runtime_error unless the mesh can have them, and their nodes are among those of the group
void require_in_groups(const Mesh& mesh, const std::map<std::string, std::vector<Triangle>>& lists) {
  constexpr int of_linear_tetrahedra = 4;
  if (!lists.empty() && element::node_count(mesh.element) != of_linear_tetrahedra) {
    refuse_table(mesh_file::group_triangles, "has lists, which only a mesh of tet4 has");
  }
  for (const auto& [name, triangles] : lists) {
    const auto group = mesh.groups.find(name);
    const auto is_member = [&](Index node) {
      return group != mesh.groups.end() && std::ranges::binary_search(group->second, node);
    };
    for (const Triangle& triangle : triangles) {
      if (!std::ranges::all_of(triangle, is_member)) {
        refuse_table(mesh_file::group_triangles,
                     fmt::format("has a triangle of the nodes {} in the list '{}', which are not all in the group '{}'",
                                 fmt::join(triangle, ", "), name, name));
      }
    }
  }
}

class MeshReader {
 public:
  explicit MeshReader(const std::filesystem::path& path) : tables_(path) {}

  StoredMesh read() {
    StoredMesh stored = read_outline();
    Mesh& mesh = stored.mesh;
    mesh.elements = tables_.read<Index, Index>(mesh_file::elements, element::node_count(mesh.element));
    require_numbers(mesh_file::elements, mesh.elements, mesh.nodes.size());
    stored.element_groups = read_numbers(mesh_file::element_groups, static_cast<std::size_t>(mesh.element_count()));
    const std::string promised = mesh.hash;
    mesh.hash = hash_of(mesh);
    require_hash(mesh.hash, promised);
    return stored;
  }

  StoredMesh read_outline() {
    StoredMesh stored;
    Mesh& mesh = stored.mesh;
    stored.body = hdf5::text_of(tables_.file(), mesh_file::body);
    mesh.hash = hdf5::text_of(tables_.file(), mesh_file::hash);
    mesh.element = read_type();
    mesh.nodes = tables_.read<double, Vector3>(mesh_file::nodes, 3);
    require_finite(mesh.nodes);
    mesh.surface = tables_.read<Index, Triangle>(mesh_file::surface, 3);
    for (const Triangle& triangle : mesh.surface) {
      require_numbers(mesh_file::surface, triangle, mesh.nodes.size());
    }
    mesh.groups = read_numbers(mesh_file::groups, mesh.nodes.size());
    mesh.group_triangles = read_triangles(mesh);
    return stored;
  }

 private:
  element::Type read_type() {
    const std::string name = hdf5::text_of(tables_.file(), mesh_file::element);
    const auto found = std::ranges::find(element::types(), name, element::name);
    if (found == element::types().end()) {
      throw std::runtime_error(fmt::format("it has elements of the unknown type '{}'", name));
    }
    if (!element::has_choice_of_orders(*found)) {
      return *found;
    }
    return element::hex(read_order(mesh_file::plane_order), read_order(mesh_file::thickness_order));
  }

  int read_order(const char* name) {
    const std::int64_t order = hdf5::integer_of(tables_.file(), name);
    if (order < element::lowest_hex_order || order > element::highest_hex_order) {
      throw std::runtime_error(fmt::format("its {} is {}, which no element has", name, order));
    }
    return static_cast<int>(order);
  }

  template <class Item>
  std::map<std::string, std::vector<Item>> read_lists(const std::string& group, int width) {
    const auto [names, begins] = read_list_outline(tables_, group, width);
    const auto members = tables_.read<Index, Item>(group + mesh_file::members, width);
    std::map<std::string, std::vector<Item>> lists;
    for (std::size_t i = 0; i < names.size(); ++i) {
      lists[names[i]].assign(members.begin() + begins[i], members.begin() + begins[i + 1]);
    }
    return lists;
  }

  /// Lists of ascending numbers of things.
  /// @param count  of these things
  std::map<std::string, std::vector<Index>> read_numbers(const std::string& group, std::size_t count) {
    auto lists = read_lists<Index>(group, 1);
    for (const auto& [name, list] : lists) {
      require_numbers(group, list, count);
      if (std::ranges::adjacent_find(list, std::ranges::greater_equal()) != list.end()) {
        refuse_table(group, fmt::format("has the list '{}', which does not ascend", name));
      }
    }
    return lists;
  }

  std::map<std::string, std::vector<Triangle>> read_triangles(const Mesh& mesh) {
    auto lists = read_lists<Triangle>(mesh_file::group_triangles, 3);
    for (const auto& [name, triangles] : lists) {
      for (const Triangle& triangle : triangles) {
        require_numbers(mesh_file::group_triangles, triangle, mesh.nodes.size());
      }
    }
    require_in_groups(mesh, lists);
    return lists;
  }

  MeshTables tables_;
};

}  // namespace

void require_hash(const std::string& hash, const std::string& promised) {
  if (hash != promised) {
    throw std::runtime_error(
        fmt::format("its mesh has the hash {}, but should have {}: the file was changed", hash, promised));
  }
}

StoredMesh read_mesh_file(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return MeshReader(path).read(); });
}

StoredMesh read_mesh_outline(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return MeshReader(path).read_outline(); });
}

}  // namespace idiophone::mesh

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "hash.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "mesh_file_paths.hpp"

namespace idiophone::mesh {

namespace {

/// @param path  of the dataset that is wrong
[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::runtime_error(fmt::format("{} {}: the mesh is not valid", path, why));
}

/// @throws std::runtime_error unless all are numbers of one of `count` things
void require_numbers(const std::string& path, std::span<const Index> numbers, std::size_t count) {
  const auto wrong =
      std::ranges::find_if(numbers, [&](Index number) { return number < 0 || std::cmp_greater_equal(number, count); });
  if (wrong != numbers.end()) {
    refuse(path, fmt::format("has the number {}, but there are {} to choose from", *wrong, count));
  }
}

void require_finite(const std::vector<Vector3>& nodes) {
  const auto wrong = std::ranges::find_if(nodes, [](const Vector3& node) { return !node.allFinite(); });
  if (wrong != nodes.end()) {
    refuse(mesh_file::nodes,
           fmt::format("has node {} at {}, which isn't a place", wrong - nodes.begin(), to_text(*wrong)));
  }
}

/// Lists as mesh.group_triangles.
/// @throws std::runtime_error unless the mesh can have them, and their nodes are among those of the group
void require_in_groups(const Mesh& mesh, const std::map<std::string, std::vector<Triangle>>& lists) {
  constexpr int of_linear_tetrahedra = 4;
  if (!lists.empty() && element::node_count(mesh.element) != of_linear_tetrahedra) {
    refuse(mesh_file::group_triangles, "has lists, which only a mesh of tet4 has");
  }
  for (const auto& [name, triangles] : lists) {
    const auto group = mesh.groups.find(name);
    const auto is_member = [&](Index node) {
      return group != mesh.groups.end() && std::ranges::binary_search(group->second, node);
    };
    for (const Triangle& triangle : triangles) {
      if (!std::ranges::all_of(triangle, is_member)) {
        refuse(mesh_file::group_triangles,
               fmt::format("has a triangle of the nodes {} in the list '{}', which are not all in the group '{}'",
                           fmt::join(triangle, ", "), name, name));
      }
    }
  }
}

class MeshReader {
 public:
  explicit MeshReader(const std::filesystem::path& path) : file_(hdf5::open_for_reading(path)) {
    files::check_format(file_.id(), files::mesh_format, path);
  }

  StoredMesh read() {
    StoredMesh stored;
    Mesh& mesh = stored.mesh;
    stored.body = hdf5::text_of(file_.id(), mesh_file::body);
    mesh.element = read_type();
    mesh.nodes = read_table<double, Vector3>(mesh_file::nodes, 3);
    require_finite(mesh.nodes);
    mesh.elements = read_table<Index, Index>(mesh_file::elements, element::node_count(mesh.element));
    mesh.surface = read_table<Index, Triangle>(mesh_file::surface, 3);
    require_numbers(mesh_file::elements, mesh.elements, mesh.nodes.size());
    for (const Triangle& triangle : mesh.surface) {
      require_numbers(mesh_file::surface, triangle, mesh.nodes.size());
    }
    mesh.groups = read_numbers(mesh_file::groups, mesh.nodes.size());
    stored.element_groups = read_numbers(mesh_file::element_groups, mesh.element_count());
    mesh.group_triangles = read_triangles(mesh);
    require_hash(mesh);
    return stored;
  }

 private:
  element::Type read_type() {
    const std::string name = hdf5::text_of(file_.id(), mesh_file::element);
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
    const std::int64_t order = hdf5::integer_of(file_.id(), name);
    if (order < element::lowest_hex_order || order > element::highest_hex_order) {
      throw std::runtime_error(fmt::format("its {} is {}, which no element has", name, order));
    }
    return static_cast<int>(order);
  }

  /// A table of numbers of type T, `width` in a row, as items of a row each, or of a number each.
  template <class T, class Item>
  std::vector<Item> read_table(const std::string& path, int width) {
    const auto dataset = hdf5::open_dataset(file_.id(), path);
    const hdf5::Dimensions shape = hdf5::shape_of(dataset.id());
    if (shape.size() != 2 || std::cmp_not_equal(shape[1], width)) {
      refuse(path, fmt::format("is no table of {} columns", width));
    }
    const hdf5::Hyperslab all = hdf5::whole(dataset.id());
    const std::size_t numbers = hdf5::stored_volume(dataset.id(), all);
    if (std::cmp_greater(numbers, std::numeric_limits<Index>::max())) {
      refuse(path, fmt::format("has {} numbers, more than the {} that can be counted", numbers,
                               std::numeric_limits<Index>::max()));
    }
    std::vector<Item> items(numbers * sizeof(T) / sizeof(Item));
    hdf5::read_bytes(dataset.id(), all, hdf5::type_of<T>(), items.data());
    if (hdf5::integer_of(dataset.id(), files::checksum_attribute) !=
        std::int64_t{files::checksum(std::as_bytes(std::span(items)))}) {
      throw std::runtime_error(fmt::format("{} does not match its checksum: the file is damaged", path));
    }
    return items;
  }

  template <class Item>
  std::map<std::string, std::vector<Item>> read_lists(const std::string& group, int width) {
    const auto names = hdf5::texts_in(file_.id(), group + mesh_file::names);
    const auto begins = read_table<Index, Index>(group + mesh_file::begins, 1);
    const auto members = read_table<Index, Item>(group + mesh_file::members, width);
    if (begins.size() != names.size() + 1 || begins.front() != 0 || !std::ranges::is_sorted(begins) ||
        std::cmp_not_equal(begins.back(), members.size())) {
      refuse(group, "has lists that do not fit their names");
    }
    std::map<std::string, std::vector<Item>> lists;
    for (std::size_t i = 0; i < names.size(); ++i) {
      lists[names[i]].assign(members.begin() + begins[i], members.begin() + begins[i + 1]);
    }
    if (lists.size() != names.size()) {
      refuse(group, "has two lists of one name");
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
        refuse(group, fmt::format("has the list '{}', which does not ascend", name));
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

  void require_hash(Mesh& mesh) {
    mesh.hash = hash_of(mesh);
    if (const std::string stored = hdf5::text_of(file_.id(), mesh_file::hash); stored != mesh.hash) {
      throw std::runtime_error(
          fmt::format("its mesh has the hash {}, but should have {}: the file was changed", mesh.hash, stored));
    }
  }

  hdf5::Identifier file_;
};

}  // namespace

StoredMesh read_mesh_file(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] { return MeshReader(path).read(); });
}

}  // namespace idiophone::mesh

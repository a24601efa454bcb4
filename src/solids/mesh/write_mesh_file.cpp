#include <span>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "mesh_file_paths.hpp"

namespace idiophone::mesh {

namespace {

class MeshWriter {
 public:
  explicit MeshWriter(const std::filesystem::path& path) : file_(hdf5::create_file(path, MPI_COMM_SELF)) {}

  void write(const StoredMesh& stored, const Origin& origin) {
    const Mesh& mesh = stored.mesh;
    files::write_origin(file_.id(), files::mesh_format, origin, MPI_COMM_SELF);
    write_facts(stored);
    write_table<double>(mesh_file::nodes, numbers_of<double>(mesh.nodes), 3);
    write_table<Index>(mesh_file::elements, mesh.elements, element::node_count(mesh.element));
    write_table<Index>(mesh_file::surface, numbers_of<Index>(mesh.surface), 3);
    write_lists<1>(mesh_file::groups, mesh.groups);
    write_lists<1>(mesh_file::element_groups, stored.element_groups);
    write_lists<3>(mesh_file::group_triangles, mesh.group_triangles);
    file_.close("can't write the mesh");
  }

 private:
  /// The numbers of points or triangles, three of each, as they lie in memory.
  template <class T, class Triple>
  static std::span<const T> numbers_of(const std::vector<Triple>& triples) {
    static_assert(sizeof(Triple) == 3 * sizeof(T));
    return {triples.empty() ? nullptr : triples.front().data(), 3 * triples.size()};
  }

  template <class T>
  void write_table(const std::string& path, std::span<const T> values, int width) {
    const auto columns = static_cast<hsize_t>(width);
    const auto dataset = hdf5::create_dataset(file_.id(), path, hdf5::type_of<T>(), {values.size() / columns, columns});
    hdf5::write(dataset.id(), hdf5::whole(dataset.id()), values, hdf5::Transfer::alone);
    files::put_checksum(dataset, files::checksum(std::as_bytes(values)), MPI_COMM_SELF);
  }

  void write_facts(const StoredMesh& stored) {
    const element::Type type = stored.mesh.element;
    hdf5::put(file_.id(), mesh_file::body, stored.body);
    hdf5::put(file_.id(), mesh_file::element, std::string(element::name(type)));
    hdf5::put(file_.id(), mesh_file::plane_order, std::int64_t{type.plane});
    hdf5::put(file_.id(), mesh_file::thickness_order, std::int64_t{type.thickness});
    hdf5::put(file_.id(), mesh_file::hash, stored.mesh.hash);
  }

  /// @tparam width  numbers of a member
  template <int width, class Lists>
  void write_lists(const std::string& group, const Lists& lists) {
    std::vector<std::string> names;
    std::vector<Index> begins = {0}, members;
    for (const auto& [name, list] : lists) {
      names.push_back(name);
      for (const auto& member : list) {
        if constexpr (width == 1) {
          members.push_back(member);
        } else {
          members.insert(members.end(), member.begin(), member.end());
        }
      }
      begins.push_back(static_cast<Index>(members.size() / width));
    }
    hdf5::put_dataset(file_.id(), group + mesh_file::names, names, MPI_COMM_SELF);
    write_table<Index>(group + mesh_file::begins, begins, 1);
    write_table<Index>(group + mesh_file::members, members, width);
  }

  hdf5::Identifier file_;
};

}  // namespace

void write_mesh_file(const std::filesystem::path& path, const StoredMesh& stored, const Origin& origin) {
  auto part = path;
  part += ".part";
  MeshWriter(part).write(stored, origin);
  files::synchronise(part);
  files::rename_durably(part, path);
}

}  // namespace idiophone::mesh

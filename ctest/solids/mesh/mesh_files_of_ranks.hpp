#pragma once
// Bodies with mesh files that ranks read in parts.

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "hash.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"
#include "samples.hpp"

namespace idiophone::mesh {

inline const Origin origin_of_parts{.name = "test", .code_version = "0", .deck_text = "name: test\n", .overrides = {}};

/// Bodies whose meshes are files. Every rank has files of its own.
class MeshesInParts : public ::testing::Test {
 protected:
  /// A body whose mesh is a file of the mesh of this one.
  void add(
      scene::Body original, const std::function<void(StoredMesh&)>& change = [](StoredMesh&) {}) {
    StoredMesh stored = storable_mesh(original);
    change(stored);
    stored.mesh.hash = hash_of(stored.mesh);
    files_.push_back(std::make_unique<TemporaryFile>(std::to_string(files_.size()) + ".mesh.h5"));
    write_mesh_file(files_.back()->path(), stored, origin_of_parts);
    original.mesh = files_.back()->path();
    original.parameters.clear();
    bodies.push_back(original);
  }

  /// What is said on rank 0 of these bodies; all ranks have to fail.
  std::string refusal_in_parts() {
    try {
      MeshShares shares = read_shares(bodies, MPI_COMM_WORLD);
      static_cast<void>(read_part(bodies, shares, {}, MPI_COMM_WORLD));
    } catch (const deck::DeckError& error) {
      return error.what();
    } catch (const parallel::RemoteFailure& error) {
      return error.what();
    }
    return "";
  }

  /// The same of a bar whose mesh was changed.
  std::string refusal_after(const std::function<void(Mesh&)>& change) {
    bodies.clear();
    add(shipped("square_plate.geo", element::tet10, {{"size", 0.05}}));
    add(shipped("bar.geo", element::tet4), [&](StoredMesh& stored) { change(stored.mesh); });
    return refusal_in_parts();
  }

  std::vector<scene::Body> bodies;

 private:
  std::vector<std::unique_ptr<TemporaryFile>> files_;
};

}  // namespace idiophone::mesh

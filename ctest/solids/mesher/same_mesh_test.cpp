// The same file gives the same mesh in every process: a run can be resumed.

#include <gtest/gtest.h>

#include <set>

#include "gmsh_session.hpp"
#include "samples.hpp"

namespace idiophone::mesher {

using namespace mesh;  // bodies and files of its tests
namespace {

/// A ring with a hole across it: a part whose mesh depends on the order in which HXT gets the nodes.
void write_ring(const std::filesystem::path& file) {
  const GmshSession session;
  gmsh::option::setString("Geometry.OCCTargetUnit", "MM");
  gmsh::vectorpair parts;
  std::vector<gmsh::vectorpair> history;
  gmsh::model::occ::cut({{3, gmsh::model::occ::addTorus(0, 0, 0, 50, 12)}},
                        {{3, gmsh::model::occ::addCylinder(0, 0, 0, 100, 0, 0, 4)}}, parts, history);
  gmsh::model::occ::synchronize();
  gmsh::write(file.string());
}

TEST(SameMesh, InTwelveProcessesAndFromFoldersOfOtherNames) {
  const auto folder = std::filesystem::temp_directory_path() / ("mesher_test_" + std::to_string(getpid()) + "_same");
  std::set<std::string> hashes;
  for (std::size_t process = 0; process < 12; ++process) {
    const auto place = folder / std::string(1 + 7 * (process % 4), 'f');
    std::filesystem::create_directories(place);
    if (process < 4) {
      write_ring(place / "ring.step");
    }
    hashes.insert(mesh::read_mesh(body_of(place / "ring.step", element::tet4, {{"size", 0.008}})).hash);
  }
  std::filesystem::remove_all(folder);
  EXPECT_EQ(hashes.size(), 1U);
}

}  // namespace
}  // namespace idiophone::mesher

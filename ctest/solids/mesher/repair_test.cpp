// Solids from surfaces of triangles that gmsh can't fill, by `repair: wrap`.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "samples.hpp"

namespace idiophone::mesher {

using namespace mesh;  // bodies and files of its tests
namespace {

using std::numbers::pi;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

using Facet = std::array<Vector3, 3>;

/// Around the centre, with facets in rings from pole to pole.
std::vector<Facet> ball(const Vector3& centre, double radius) {
  constexpr int rings = 24, sectors = 48;
  const auto place = [&](int ring, int sector) -> Vector3 {
    const double polar = pi * ring / rings, azimuth = 2.0 * pi * (sector % sectors) / sectors;
    return centre + radius * Vector3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                                     ring == rings ? -1.0 : std::cos(polar));
  };
  std::vector<Facet> facets;
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const Vector3 a = place(ring, sector), b = place(ring + 1, sector), c = place(ring + 1, sector + 1),
                    d = place(ring, sector + 1);
      if (ring + 1 < rings) {
        facets.push_back({a, b, c});
      }
      if (ring > 0) {
        facets.push_back({a, c, d});
      }
    }
  }
  return facets;
}

/// A box from the origin, with 2 x `cells` x `cells` facets on each side.
std::vector<Facet> block(const Vector3& size, int cells) {
  std::vector<Facet> facets;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const auto place = [&](int i, int j) -> Vector3 {
        Vector3 point;
        point[axis] = side;
        point[(axis + 1) % 3] = double(i) / cells;
        point[(axis + 2) % 3] = double(j) / cells;
        return point.cwiseProduct(size);
      };
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          facets.push_back({place(i, j), place(i + 1, j), place(i + 1, j + 1)});
          facets.push_back({place(i, j), place(i + 1, j + 1), place(i, j + 1)});
        }
      }
    }
  }
  return facets;  // half of them face inwards
}

std::string obj_text(const std::vector<Facet>& facets) {
  std::string text;
  for (const Facet& facet : facets) {
    for (const Vector3& corner : facet) {
      text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", corner[0], corner[1], corner[2]);
    }
    text += "f -3 -2 -1\n";
  }
  return text;
}

/// With holes, and with facets that lie twice or face the other way.
std::vector<Facet> damaged(std::vector<Facet> facets) {
  for (const std::size_t hole : {90, 301, 604}) {
    facets.erase(facets.begin() + static_cast<std::ptrdiff_t>(hole % facets.size()));
  }
  for (const std::size_t i : {7, 70, 405}) {
    facets.push_back(facets[i % facets.size()]);
    std::swap(facets[(i + 5) % facets.size()][0], facets[(i + 5) % facets.size()][1]);
  }
  return facets;
}

scene::Body repaired(const TemporaryFile& file, double size, std::optional<double> gap = std::nullopt) {
  scene::Body body = body_of(file.path(), element::tet4, {{"size", size}});
  body.meshing.repair = scene::Repair::wrap;
  body.meshing.gap = gap;
  return body;
}

TEST(Repair, ClosesTheHolesOfABall) {
  const TemporaryFile file("ball.obj", obj_text(damaged(ball(Vector3::Zero(), 0.05))));
  const Mesh mesh = read_mesh(repaired(file, 0.01));
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(enclosed_volume(mesh) / (4.0 / 3.0 * pi * std::pow(0.05, 3)), 1.0, 0.015);  // the facets have 0.9 % less
  EXPECT_THAT(mesh.notes, Contains(AllOf(HasSubstr("replaces the file's 2208. "), HasSubstr("are not closed"))));
  EXPECT_EQ(read_mesh(repaired(file, 0.01)).hash, mesh.hash);
}

TEST(Repair, KeepsTheEdgesOfABox) {
  const Vector3 size(0.1, 0.08, 0.06);
  const TemporaryFile file("box.obj", obj_text(damaged(block(size, 12))));
  const Mesh mesh = read_mesh(repaired(file, 0.012));
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(enclosed_volume(mesh) / size.prod(), 1.0, 1e-4);
  for (const char* face : {"face_2", "face_7"}) {
    EXPECT_TRUE(mesh.groups.contains(face)) << face;
  }
}

TEST(Repair, JoinsSurfacesThatCrossEachOther) {
  constexpr double radius = 0.03, distance = 0.04;
  std::vector<Facet> facets = ball(Vector3::Zero(), radius);
  for (const Facet& facet : ball(distance * Vector3::UnitX(), radius)) {
    facets.push_back(facet);
  }
  const TemporaryFile file("two.obj", obj_text(facets));
  const Mesh mesh = read_mesh(repaired(file, 0.006));
  EXPECT_TRUE(is_watertight(mesh));
  const double overlap = pi * (4.0 * radius + distance) * std::pow(2.0 * radius - distance, 2) / 12.0;
  EXPECT_NEAR(enclosed_volume(mesh) / (8.0 / 3.0 * pi * std::pow(radius, 3) - overlap), 1.0, 0.015);
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("(overlaps count twice)")));
}

TEST(Repair, NeedsAnInside) {
  const TemporaryFile sheet("sheet.obj", obj_text({{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()}}));
  EXPECT_THAT(refusal(repaired(sheet, 0.1)), AllOf(HasSubstr("deck.yaml:7:9: "), HasSubstr("has no inside")));
  std::vector<Facet> open = ball(Vector3::Zero(), 0.05);
  open.resize(open.size() - 48 * 7);  // leaves an opening of 0.038 m
  const TemporaryFile bowl("bowl.obj", obj_text(open));
  EXPECT_THAT(refusal(repaired(bowl, 0.02, 0.01)), HasSubstr("Close wider ones by the key `gap`"));
  EXPECT_TRUE(is_watertight(read_mesh(repaired(bowl, 0.02, 0.05))));
}

TEST(Repair, IsProposedWhereASurfaceCannotBeFilled) {
  std::vector<Facet> facets = block(Vector3::Constant(0.05), 1);
  for (Facet facet : block(Vector3::Constant(0.05), 1)) {
    for (Vector3& corner : facet) {
      corner += Vector3(0.02, 0.03, 0.01);
    }
    facets.push_back(facet);
  }
  const TemporaryFile crossing("crossing.obj", obj_text(facets));
  EXPECT_THAT(refusal(body_of(crossing.path(), element::tet4, {{"size", 0.02}})),
              AllOf(HasSubstr("crosses itself, for example at ("), HasSubstr("meshing: {repair: wrap}")));
}

TEST(Repair, MakesNoWalls) {
  const TemporaryFile file("ball.obj", obj_text(ball(Vector3::Zero(), 0.05)));
  scene::Body body = repaired(file, 0.01);
  body.thickness = 0.001;
  EXPECT_THAT(refusal(body), HasSubstr("`repair` makes a solid of it"));
}

}  // namespace
}  // namespace idiophone::mesher

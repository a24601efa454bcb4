#include "idiophone/solids/contact/rigid_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/solids/contact/skin.hpp"
#include "tetrahedron.hpp"

namespace idiophone::contact {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

void add_part(RigidShape& shape, const std::vector<Plane>& planes, const Box& box) {
  shape.planes.insert(shape.planes.end(), planes.begin(), planes.end());
  shape.exterior.insert(shape.exterior.end(), planes.size(), 1);
  shape.first_plane.push_back(static_cast<Index>(shape.planes.size()));
  shape.boxes.push_back(box);
}

std::vector<Plane> box_planes(const scene::Obstacle& box) {
  const double angle = box.rotation.norm();
  const Eigen::Matrix3d turn =
      angle > 0 ? Eigen::AngleAxisd(angle, box.rotation / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3 normal = sign * turn.col(axis);
      planes.push_back({normal, box.at + box.size[axis] / 2 * normal});
    }
  }
  return planes;
}

/// Corner directions of an icosahedron whose faces are quartered three times: 20 x 4^3 facets.
std::vector<std::array<Vector3, 3>> sphere_triangles() {
  const double golden = std::numbers::phi;
  std::vector<Vector3> corners;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      corners.insert(corners.end(), {Vector3(0, a, b), Vector3(a, b, 0), Vector3(b, 0, a)});
    }
  }
  std::vector<std::array<Vector3, 3>> triangles;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        const auto near = [&](std::size_t m, std::size_t n) { return (corners[m] - corners[n]).norm() < 2.1; };
        if (near(i, j) && near(j, k) && near(i, k)) {
          triangles.push_back({corners[i].normalized(), corners[j].normalized(), corners[k].normalized()});
        }
      }
    }
  }
  while (triangles.size() < sphere_facets) {
    std::vector<std::array<Vector3, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const Vector3 ab = (a + b).normalized();
      const Vector3 bc = (b + c).normalized();
      const Vector3 ca = (c + a).normalized();
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles.swap(finer);
  }
  return triangles;
}

std::vector<Plane> sphere_planes(const scene::Obstacle& sphere) {
  // Facets touch a sphere a little larger than the one inside and smaller than the one outside, so that the volume is
  // right: cones from the centre over every facet, of solid angles that add up to 4 pi.
  std::vector<Plane> planes;
  double volume = 0.0;  // of the polyhedron through the corners of the unit sphere
  for (const auto& [a, b, c] : sphere_triangles()) {
    const Vector3 across = (b - a).cross(c - a);
    const Vector3 normal = across.dot(a) > 0 ? across.normalized() : -across.normalized();
    planes.push_back({normal, a});
    volume += std::abs(a.dot(b.cross(c))) / 6;
  }
  const double scale = sphere.radius * std::cbrt(4 * std::numbers::pi / 3 / volume);
  for (Plane& plane : planes) {
    plane.point = sphere.at + scale * plane.point;
  }
  return planes;
}

std::vector<Plane> cylinder_planes(const scene::Obstacle& cylinder) {
  const Vector3& axis = cylinder.direction;
  std::vector<Plane> planes = {{axis, cylinder.at + cylinder.length / 2 * axis},
                               {-axis, cylinder.at - cylinder.length / 2 * axis}};
  const Vector3 side = axis.unitOrthogonal();
  const Vector3 front = axis.cross(side);
  // A regular polygon of the same area: n r^2 tan(pi/n) = pi radius^2.
  const double angle = std::numbers::pi / cylinder_facets;
  const double inner = cylinder.radius * std::sqrt(angle / std::tan(angle));
  for (int facet = 0; facet < cylinder_facets; ++facet) {
    const Vector3 normal = std::cos(2 * facet * angle) * side + std::sin(2 * facet * angle) * front;
    planes.push_back({normal, cylinder.at + inner * normal});
  }
  return planes;
}

/// The outer layer of the tetrahedra that gmsh fills a surface with.
RigidShape surface_shape(const scene::Obstacle& surface) {
  scene::Body body;
  body.name = surface.name;
  body.mesh = surface.mesh;
  body.mesh_where = surface.mesh_where;
  body.object = surface.object;
  body.object_where = surface.object_where;
  body.meshing = surface.meshing;
  body.parameters = surface.parameters;
  body.parameters_where = surface.parameters_where;
  body.element = element::tet4;
  const mesh::Mesh mesh = mesh::read_mesh(body);
  const Skin skin = make_skin(mesh, 0);
  RigidShape shape;
  shape.first_plane = {0};
  for (std::size_t cell = 0; cell < skin.cells.size(); ++cell) {
    std::array<Vector3, 4> corners;
    Box box;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Index node = skin.nodes[skin.cells[cell].at(corner)];
      corners.at(corner) = surface.at + mesh.nodes[node];
      box.extend(corners.at(corner));
    }
    const Tetrahedron tetrahedron(corners);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      shape.planes.push_back(tetrahedron.plane(corner));
      shape.exterior.push_back(skin.exterior[cell].at(corner));
    }
    shape.first_plane.push_back(static_cast<Index>(shape.planes.size()));
    shape.boxes.push_back(box);
  }
  return shape;
}

}  // namespace

RigidShape make_shape(const scene::Obstacle& obstacle) {
  if (obstacle.shape == scene::Obstacle::Shape::surface) {
    return surface_shape(obstacle);
  }
  RigidShape shape;
  shape.first_plane = {0};
  const auto around = [&](double radius) {
    return Box(obstacle.at - Vector3::Constant(radius), obstacle.at + Vector3::Constant(radius));
  };
  switch (obstacle.shape) {
    case scene::Obstacle::Shape::half_space:
      add_part(shape, {{obstacle.direction, obstacle.at}}, around(unbounded));
      break;
    case scene::Obstacle::Shape::box:
      add_part(shape, box_planes(obstacle), around(obstacle.size.norm() / 2));
      break;
    case scene::Obstacle::Shape::sphere:
      add_part(shape, sphere_planes(obstacle), around(1.01 * obstacle.radius));
      break;
    default:
      add_part(shape, cylinder_planes(obstacle), around(std::hypot(obstacle.radius, obstacle.length / 2) * 1.01));
  }
  return shape;
}

RigidShape broadcast(RigidShape shape, MPI_Comm communicator) {
  parallel::broadcast(shape.planes, communicator);
  parallel::broadcast(shape.exterior, communicator);
  parallel::broadcast(shape.first_plane, communicator);
  std::vector<Vector3> corners;
  for (const Box& box : shape.boxes) {
    corners.insert(corners.end(), {box.min(), box.max()});
  }
  parallel::broadcast(corners, communicator);
  shape.boxes.clear();
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    shape.boxes.emplace_back(corners[i], corners[i + 1]);
  }
  return shape;
}

}  // namespace idiophone::contact

#include "idiophone/solids/motion/loaded_triangles.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/linear_part.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::motion {

namespace {

/// A triangle of the surface, by global numbers.
struct GlobalTriangle {
  Index number;
  mesh::Triangle corners;
  mesh::Triangle key;  ///< the same corners, the smallest first
  Index place = 0;     ///< among all, by number
};

mesh::Triangle smallest_first(mesh::Triangle triangle) {
  mesh::turn_smallest_first(triangle);
  return triangle;
}

/// Of all ranks, by key. Collective.
std::vector<GlobalTriangle> all_triangles(const mesh::Part& part, const std::vector<bool>& moving,
                                          MPI_Comm communicator) {
  std::vector<GlobalTriangle> own;
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    if (moving[part.triangle_body[t]]) {
      mesh::Triangle corners;
      std::ranges::transform(part.surface[t], corners.begin(),
                             [&](Index vertex) { return part.node_ids[part.vertices[vertex]]; });
      own.push_back({.number = part.triangle_ids[t], .corners = corners, .key = smallest_first(corners)});
    }
  }
  std::vector<GlobalTriangle> all = parallel::gather_all(std::span<const GlobalTriangle>(own), communicator).values;
  std::ranges::sort(all, {}, &GlobalTriangle::number);
  for (std::size_t place = 0; place < all.size(); ++place) {
    all[place].place = static_cast<Index>(place);
  }
  std::ranges::sort(all, {}, &GlobalTriangle::key);
  return all;
}

/// [local nodes] whether they are on the surface.
std::vector<bool> find_surface_nodes(const mesh::Part& part, const std::vector<GlobalTriangle>& all) {
  std::vector<Index> on_surface;  // global, ascending
  for (const GlobalTriangle& triangle : all) {
    on_surface.insert(on_surface.end(), triangle.key.begin(), triangle.key.end());
  }
  keep_each_once(on_surface);
  std::vector<bool> result;
  for (const Index node : part.node_ids) {
    result.push_back(std::ranges::binary_search(on_surface, node));
  }
  return result;
}

class Finder {
 public:
  Finder(const mesh::Part& part, const std::vector<bool>& moving, MPI_Comm communicator)
      : part_(part), all_(all_triangles(part, moving, communicator)), is_on_surface_(find_surface_nodes(part, all_)) {}

  void add_element(const mesh::BodyPart& body, std::span<const Index> nodes) {
    const element::ReferenceElement& reference = element::reference(body.element);
    for (const element::Face& face : reference.faces) {
      const auto is_surface = [&](int place) { return is_on_surface_[nodes[place]]; };
      const auto is_owned = [&](int place) { return nodes[place] < part_.owned_nodes; };
      if (std::ranges::all_of(face.nodes, is_surface) && std::ranges::any_of(face.nodes, is_owned)) {
        for (const auto& places : face.triangles) {
          add_triangle(reference, face, places, nodes);
        }
      }
    }
  }

  [[nodiscard]] LoadedTriangles found() {
    std::ranges::sort(found_, {}, &Found::number);
    LoadedTriangles result;
    result.all = static_cast<Index>(all_.size());
    for (Found& found : found_) {
      result.numbers.push_back(found.number);
      result.places.push_back(found.place);
      result.triangles.push_back(std::move(found.triangle));
    }
    return result;
  }

 private:
  struct Found {
    Index number, place;
    LoadedTriangle triangle;
  };

  /// Of a face that may be inside the body all the same: then no triangle of the surface has these corners.
  void add_triangle(const element::ReferenceElement& reference, const element::Face& face,
                    const std::array<int, 3>& places, std::span<const Index> nodes) {
    const auto global = [&](int place) { return part_.node_ids[nodes[place]]; };
    const mesh::Triangle key = smallest_first({global(places[0]), global(places[1]), global(places[2])});
    const auto triangle = std::ranges::lower_bound(all_, key, {}, &GlobalTriangle::key);
    if (triangle == all_.end() || triangle->key != key) {
      return;
    }
    std::array<int, 3> corners{};  // the same places, in the order of the surface
    std::ranges::transform(triangle->corners, corners.begin(),
                           [&](Index node) { return *std::ranges::find(places, node, global); });
    LoadedTriangle loaded{.corners = {}, .nodes = {}, .shapes = shapes(reference, face, corners)};
    std::ranges::transform(corners, loaded.corners.begin(), [&](int place) { return nodes[place]; });
    std::ranges::transform(face.nodes, std::back_inserter(loaded.nodes), [&](int place) { return nodes[place]; });
    found_.push_back({triangle->number, triangle->place, std::move(loaded)});
  }

  /// All elements of a type share them.
  std::shared_ptr<const Eigen::Matrix3Xd> shapes(const element::ReferenceElement& reference, const element::Face& face,
                                                 const std::array<int, 3>& corners) {
    auto& shapes = shapes_[{reference.type, face.nodes, corners}];
    if (!shapes) {
      shapes = std::make_shared<const Eigen::Matrix3Xd>(element::linear_part(reference, face, corners));
    }
    return shapes;
  }

  const mesh::Part& part_;
  std::vector<GlobalTriangle> all_;
  std::vector<bool> is_on_surface_;
  std::map<std::tuple<element::Type, std::vector<int>, std::array<int, 3>>, std::shared_ptr<const Eigen::Matrix3Xd>>
      shapes_;
  std::vector<Found> found_;
};

}  // namespace

LoadedTriangles loaded_triangles(const mesh::Part& part, const std::vector<bool>& moving, MPI_Comm communicator) {
  Finder finder(part, moving, communicator);
  for (const mesh::BodyPart& body : part.bodies) {
    for (std::size_t place = 0; place < body.element_ids.size(); ++place) {
      finder.add_element(body, body.element_nodes(place));
    }
  }
  return finder.found();
}

}  // namespace idiophone::motion

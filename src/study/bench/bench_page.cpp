#include "idiophone/study/bench/bench_page.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench_page_files.hpp"

namespace idiophone::bench {

namespace {

/// Nodes of the surface as the vertices of the page.
struct Vertices {
  std::vector<Index> of_node;            ///< [nodes] -1 inside the body
  std::vector<float> places;             ///< [3 x vertices] m
  std::vector<std::uint32_t> triangles;  ///< [3 x triangles]
};

Vertices vertices_of(const mesh::Mesh& mesh) {
  Vertices result{std::vector<Index>(mesh.nodes.size(), -1), {}, {}};
  for (const mesh::Triangle& triangle : mesh.outer_surface()) {
    for (const Index node : triangle) {
      if (result.of_node[node] < 0) {
        result.of_node[node] = static_cast<Index>(result.places.size() / 3);
        for (const double coordinate : mesh.nodes[node]) {
          result.places.push_back(static_cast<float>(coordinate));
        }
      }
      result.triangles.push_back(static_cast<std::uint32_t>(result.of_node[node]));
    }
  }
  return result;
}

/// Cents for each millimetre over 1 cm2; no number where the surface is held. [vertices]
std::vector<float> slopes_of_page(const Vertices& vertices, const eigenmodes::RemovalSlopes& removal,
                                  const std::vector<double>& slopes) {
  constexpr double volume = 1e-3 * 1e-4;  // m3
  std::vector<float> result(vertices.places.size() / 3, std::nanf(""));
  for (std::size_t i = 0; i < removal.nodes.size(); ++i) {
    result[vertices.of_node[removal.nodes[i]]] = static_cast<float>(volume * slopes[i]);
  }
  return result;
}

}  // namespace

std::string page(const nlohmann::json& facts, const mesh::Mesh& mesh, const eigenmodes::RemovalSlopes& removal) {
  const Vertices vertices = vertices_of(mesh);
  nlohmann::json data = {{"facts", facts},
                         {"vertices", web::encoded(vertices.places)},
                         {"triangles", web::encoded(vertices.triangles)},
                         {"slopes", nlohmann::json::array()}};
  for (const std::vector<double>& slopes : removal.slopes) {
    data["slopes"].push_back(web::encoded(slopes_of_page(vertices, removal, slopes)));
  }
  return web::filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::bench

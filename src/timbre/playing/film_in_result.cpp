// The film of proxies as meshes and frames of a result.

#include <numeric>
#include <vector>

#include "cast.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::timbre {

namespace {

/// All rows of a table, on one rank.
parallel::Rows all_rows(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return {numbers, static_cast<std::int64_t>(count), MPI_COMM_SELF};
}

}  // namespace

void write_film(const voices::ProxyFilm& film, results::ResultFile& result) {
  std::vector<parallel::Rows> nodes;
  for (const voices::FilmedBody& body : film.bodies()) {
    std::vector<double> places;
    for (const Vector3& node : body.nodes) {
      places.insert(places.end(), node.begin(), node.end());
    }
    std::vector<Index> corners;
    for (const auto& tetrahedron : body.tetrahedra) {
      corners.insert(corners.end(), tetrahedron.begin(), tetrahedron.end());
    }
    nodes.push_back(all_rows(body.nodes.size()));
    result.add_mesh(body.name, nodes.back(), places, all_rows(body.tetrahedra.size()), corners, element::tet4);
  }
  for (const voices::FilmFrame& frame : film.frames()) {
    std::vector<results::BodyFrame> bodies;
    for (std::size_t body = 0; body < nodes.size(); ++body) {
      bodies.push_back({film.bodies()[body].name, &nodes[body], frame.displacement[body]});
    }
    result.add_frame(frame.time, bodies);
  }
}

}  // namespace idiophone::timbre

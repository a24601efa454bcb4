// The film of proxies as meshes and frames of a result.

#include <vector>

#include "cast.hpp"
#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_frames.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::timbre {

void write_film(const voices::ProxyFilm& film, results::ResultFile& result) {
  std::vector<parallel::Rows> nodes;
  for (const voices::FilmedBody& body : film.bodies()) {
    nodes.push_back(proxy_bodies::add_tetrahedra(body.name, body.nodes, body.tetrahedra, result));
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

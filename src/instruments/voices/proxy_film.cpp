#include "idiophone/instruments/voices/proxy_film.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::voices {

namespace {

/// @param breaks  each tetrahedron gets nodes of its own
FilmedBody filmed(const std::string& name, const proxies::TetrahedralMesh& mesh, bool breaks) {
  if (!breaks) {
    return {.name = name, .nodes = mesh.nodes, .tetrahedra = mesh.tetrahedra, .breaks = false};
  }
  FilmedBody body{.name = name, .nodes = {}, .tetrahedra = {}, .breaks = true};
  for (const auto& tetrahedron : mesh.tetrahedra) {
    auto& own = body.tetrahedra.emplace_back();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      own[corner] = static_cast<Index>(body.nodes.size());
      body.nodes.push_back(mesh.nodes[tetrahedron[corner]]);
    }
  }
  return body;
}

/// The displacements of what a part has of a body.
void put(const proxies::Fragment& part, const Eigen::Isometry3d& pose, const FilmedBody& body,
         std::vector<double>& displacement) {
  const auto& mesh = part.lattice->mesh();
  const auto put_node = [&](Index node, Index filmed_node) {
    const Vector3 moved = pose * (mesh.nodes[node] + part.displacement[node]) - body.nodes[filmed_node];
    std::ranges::copy(moved, &displacement[3 * static_cast<std::size_t>(filmed_node)]);
  };
  if (!body.breaks) {
    for (Index node = 0; node < std::ssize(body.nodes); ++node) {
      put_node(node, node);
    }
    return;
  }
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const std::size_t whole = mesh.origin.empty() ? t : mesh.origin[t];
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Index node = mesh.tetrahedra[t][corner], filmed_node = body.tetrahedra[whole][corner];
      if (mesh.nodes[node] == body.nodes[filmed_node]) {  // not the middle of a spring that was split
        put_node(node, filmed_node);
      }
    }
  }
}

}  // namespace

ProxyFilm::ProxyFilm(const proxies::Engine& engine, const std::vector<std::string>& names, double frames_per_second,
                     int rate)
    : samples_per_frame_(rate / frames_per_second), rate_(rate) {
  for (std::size_t body = 0; body < names.size(); ++body) {
    const proxies::BodyOptions& options = engine.body(body);
    bodies_.push_back(filmed(names[body], options.levels.front()->mesh(), std::isfinite(options.strength.tensile)));
  }
}

std::int64_t ProxyFilm::next_sample() const {
  return static_cast<std::int64_t>(std::ceil(static_cast<double>(frames_.size()) * samples_per_frame_));
}

std::int64_t ProxyFilm::samples_until_frame(std::int64_t sample) const {
  return std::max<std::int64_t>(0, next_sample() - sample);
}

void ProxyFilm::add(const proxies::Engine& engine, std::span<const std::size_t> roots,
                    const std::function<Eigen::Isometry3d(std::size_t body)>& pose) {
  FilmFrame frame{.time = static_cast<double>(engine.now()) / rate_, .displacement = {}};
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    frame.displacement.push_back(frames_.empty() ? std::vector<double>(3 * bodies_[body].nodes.size())
                                                 : frames_.back().displacement[body]);
  }
  for (std::size_t body = 0; body < roots.size(); ++body) {
    if (engine.is_whole(body)) {
      put(engine.motion(body), pose(body), bodies_[roots[body]], frame.displacement[roots[body]]);
    }
  }
  frames_.push_back(std::move(frame));
}

}  // namespace idiophone::voices

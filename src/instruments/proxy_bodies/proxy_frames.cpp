#include "idiophone/instruments/proxy_bodies/proxy_frames.hpp"

#include <numeric>
#include <utility>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/run/record/frame_recorder.hpp"

namespace idiophone::proxy_bodies {

namespace {

/// All rows of a table, on one rank.
parallel::Rows all_rows(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return {numbers, static_cast<std::int64_t>(count), MPI_COMM_SELF};
}

}  // namespace

parallel::Rows add_tetrahedra(const std::string& body, std::span<const Vector3> nodes,
                              std::span<const std::array<Index, 4>> tetrahedra, results::ResultFile& result) {
  std::vector<double> places;
  for (const Vector3& node : nodes) {
    places.insert(places.end(), node.begin(), node.end());
  }
  std::vector<Index> corners;
  for (const auto& tetrahedron : tetrahedra) {
    corners.insert(corners.end(), tetrahedron.begin(), tetrahedron.end());
  }
  parallel::Rows rows = all_rows(nodes.size());
  result.add_mesh(body, rows, places, all_rows(tetrahedra.size()), corners, element::tet4);
  return rows;
}

ProxyFrames::ProxyFrames(std::vector<ProxyBody> bodies, const ProxySource& source, const scene::Scene& scene,
                         results::ResultFile& result)
    : bodies_(std::move(bodies)), source_(source), scene_(scene), result_(result) {}

void ProxyFrames::declare() {
  for (const ProxyBody& body : bodies_) {
    const proxies::TetrahedralMesh& mesh = body.lattice->mesh();
    nodes_.push_back(add_tetrahedra(body.name, mesh.nodes, mesh.tetrahedra, result_));
  }
}

void ProxyFrames::note(std::int64_t /*sample*/, const surface::SurfaceMotion& /*motion*/) {
  if (!record::is_frame_due(scene_, source_.advanced())) {
    return;
  }
  Frame& frame = frames_.emplace_back();
  frame.time = static_cast<double>(source_.advanced()) / scene_.audio.rate;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    frame.displacement.push_back(source_.displacement(body));
  }
}

void ProxyFrames::write() {
  for (const Frame& frame : frames_) {
    std::vector<results::BodyFrame> bodies;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      bodies.push_back({bodies_[body].name, &nodes_[body], frame.displacement[body]});
    }
    result_.add_frame(frame.time, bodies);
  }
  frames_.clear();
}

}  // namespace idiophone::proxy_bodies

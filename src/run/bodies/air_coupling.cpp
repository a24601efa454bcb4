#include "idiophone/run/bodies/air_coupling.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>

#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::bodies {

namespace {

/// A triangle of the surface, by global numbers.
struct GlobalTriangle {
  Index number;
  std::array<Index, 3> nodes;
};

/// Of all ranks, by number. Collective.
std::vector<GlobalTriangle> all_triangles(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<GlobalTriangle> own(part.surface.size());
  for (std::size_t t = 0; t < own.size(); ++t) {
    GlobalTriangle& triangle = own[t];
    triangle.number = part.triangle_ids[t];
    std::ranges::transform(part.surface[t], triangle.nodes.begin(),
                           [&](Index vertex) { return part.node_ids[part.vertices[vertex]]; });
  }
  std::vector<GlobalTriangle> all = parallel::gather_all(std::span<const GlobalTriangle>(own), communicator).values;
  std::ranges::sort(all, {}, &GlobalTriangle::number);
  return all;
}

}  // namespace

AirCoupling::Triangles AirCoupling::touched_triangles(const mesh::Part& part, MPI_Comm communicator) {
  std::unordered_map<Index, Index> local;
  for (std::size_t node = 0; node < part.node_ids.size(); ++node) {
    local.emplace(part.node_ids[node], static_cast<Index>(node));
  }
  const auto is_owned = [&](Index node) {
    const auto found = local.find(node);
    return found != local.end() && found->second < part.owned_nodes;
  };
  Triangles touched;
  for (const auto& [number, nodes] : all_triangles(part, communicator)) {
    if (std::ranges::any_of(nodes, is_owned)) {  // then its element is computed here, and has all its nodes here
      touched.numbers.push_back(number);
      std::ranges::transform(nodes, touched.corners.emplace_back().begin(), [&](Index node) { return local.at(node); });
    }
  }
  return touched;
}

AirCoupling::AirCoupling(const Preparation& ready, motion::Motion& motion, propagation::AirLoad& air,
                         MPI_Comm communicator)
    : motion_(motion),
      air_(air),
      interval_(ready.steps_per_sample / air.steps()),
      triangles_(touched_triangles(ready.part, communicator)),
      rows_(triangles_.numbers, ready.part.global_triangles, communicator),
      load_(triangles_.corners, ready.part.reference, interval_ * ready.step()),
      changes_(triangles_.numbers.size()) {
  air.connect(triangles_.numbers);
  motion.add_load(load_);
}

void AirCoupling::after_step() {
  if (motion_.step_number() % interval_ != 0) {
    load_.go_on();
    return;
  }
  load_.end_interval(motion_.state(), changes_);
  air_.advance(changes_, load_.force(), load_.resistance());
  load_.begin_interval(motion_.state());
}

void AirCoupling::archive(parallel::Archive& archive) {
  load_.archive(archive, rows_, motion_.state());
}

}  // namespace idiophone::bodies

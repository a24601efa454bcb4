#include "idiophone/solids/motion/attachments.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "hinge.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/solids/mesh/local_numbers.hpp"

namespace idiophone::motion {

namespace {

mesh::Patch shifted(mesh::Patch patch, Index offset) {
  for (Index& node : patch.nodes) {
    node += offset;
  }
  return patch;
}

std::vector<mesh::FractureFace> shifted(std::vector<mesh::FractureFace> faces, Index offset) {
  for (mesh::FractureFace& face : faces) {
    for (auto& side : face.nodes) {
      std::ranges::for_each(side, [&](Index& node) { node += offset; });
    }
  }
  return faces;
}

/// Takes rank 0's faces. Collective.
void broadcast(std::vector<mesh::FractureFace>& faces, MPI_Comm communicator) {
  faces.resize(parallel::from_root(faces.size(), communicator));
  for (mesh::FractureFace& face : faces) {
    for (std::size_t* number : {&face.surface, &face.corners, &face.triangles}) {
      parallel::broadcast(*number, communicator);
    }
    for (auto& side : face.nodes) {
      parallel::broadcast(side, communicator);
    }
    parallel::broadcast(face.shares, communicator);
  }
}

Vector3 mean_point(const mesh::Patch& patch, const mesh::Mesh& mesh) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
    sum += patch.shares[n] * mesh.nodes[patch.nodes[n]];
  }
  return sum;
}

/// The surfaces of one body or of all.
std::vector<mesh::Triangle> surfaces(const std::vector<mesh::Mesh>& meshes, const std::vector<Index>& offset,
                                     std::optional<std::size_t> only) {
  std::vector<mesh::Triangle> all;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    if (only && *only != b) {
      continue;
    }
    for (const auto& [i, j, k] : meshes[b].outer_surface()) {
      all.push_back({i + offset[b], j + offset[b], k + offset[b]});
    }
  }
  return all;
}

/// Visits every patch in one order, the same on all ranks.
template <class Visitor>
void for_each_patch(Attachments& attachments, Visitor visit) {
  std::ranges::for_each(attachments.pulses, visit);
  std::ranges::for_each(attachments.plucks, visit);
  std::ranges::for_each(attachments.bows, visit);
  for (auto& points : attachments.gauges) {
    std::ranges::for_each(points, visit);
  }
  for (auto& body : attachments.bodies) {
    std::ranges::for_each(body.fixed, visit);
    std::ranges::for_each(body.driven, visit);
    std::ranges::for_each(body.supports, visit);
  }
}

Attachments empty_for(const scene::Solids& solids) {
  Attachments attachments;
  attachments.pulses.resize(solids.pulses.size());
  attachments.plucks.resize(solids.plucks.size());
  attachments.bows.resize(solids.bows.size());
  attachments.winds.resize(solids.winds.size());
  for (const auto& gauge : solids.gauges) {
    attachments.gauges.emplace_back(gauge.points.size());
  }
  attachments.bodies.resize(solids.bodies.size());
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    attachments.bodies[b].fixed.resize(solids.bodies[b].fixed.size());
    attachments.bodies[b].driven.resize(solids.bodies[b].driven.size());
    attachments.bodies[b].supports.resize(solids.bodies[b].supports.size());
  }
  return attachments;
}

}  // namespace

Attachments attach(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  return attach(solids, meshes, joints::held_parts(solids, meshes));
}

Attachments attach(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, const joints::HeldParts& held) {
  Attachments attachments;
  const std::vector<Index> offset = mesh::offsets(meshes).nodes;
  for (const auto& pulse : solids.pulses) {
    const mesh::Patch patch = mesh::find_patch(meshes[pulse.body], pulse.place);
    attachments.pulse_points.push_back(mean_point(patch, meshes[pulse.body]));
    attachments.pulses.push_back(shifted(patch, offset[pulse.body]));
  }
  for (const auto& pluck : solids.plucks) {
    attachments.plucks.push_back(shifted(mesh::find_patch(meshes[pluck.body], pluck.place), offset[pluck.body]));
  }
  for (const auto& bow : solids.bows) {
    attachments.bows.push_back(shifted(mesh::find_patch(meshes[bow.body], bow.place), offset[bow.body]));
  }
  for (const auto& wind : solids.winds) {
    attachments.winds.push_back(surfaces(meshes, offset, wind.body));
  }
  for (const auto& gauge : solids.gauges) {
    auto& points = attachments.gauges.emplace_back();
    for (const auto& [body, place] : gauge.points) {
      points.push_back(shifted(mesh::find_patch(meshes[body], place), offset[body]));
    }
  }
  attachments.joints = joints::find_joints(solids, meshes, held);
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    auto& of_body = attachments.bodies.emplace_back();
    for (const auto& fixed : solids.bodies[b].fixed) {
      const std::vector<Index>& nodes = mesh::find_group(meshes[b], fixed.group, fixed.where);
      if (fixed.hinge) {
        require_straight(fixed, nodes, meshes[b].nodes);
      }
      of_body.fixed.push_back(shifted({nodes, {}}, offset[b]));
    }
    for (const auto& driven : solids.bodies[b].driven) {
      of_body.driven.push_back(shifted({mesh::find_group(meshes[b], driven.group, driven.where), {}}, offset[b]));
    }
    for (const auto& support : solids.bodies[b].supports) {
      of_body.supports.push_back(shifted(mesh::find_patch(meshes[b], support.place), offset[b]));
    }
    of_body.fracture = shifted(meshes[b].fracture_faces, offset[b]);
  }
  return attachments;
}

Attachments broadcast(Attachments attachments, const scene::Solids& solids, MPI_Comm communicator) {
  if (!parallel::is_root(communicator)) {
    attachments = empty_for(solids);
  }
  for_each_patch(attachments, [&](mesh::Patch& patch) {
    parallel::broadcast(patch.nodes, communicator);
    parallel::broadcast(patch.shares, communicator);
  });
  for (auto& triangles : attachments.winds) {
    parallel::broadcast(triangles, communicator);
  }
  for (auto& body : attachments.bodies) {
    broadcast(body.fracture, communicator);
  }
  parallel::broadcast(attachments.pulse_points, communicator);
  attachments.joints = joints::broadcast(std::move(attachments.joints), communicator);
  return attachments;
}

std::vector<std::vector<Index>> coupled_nodes(const Attachments& attachments) {
  std::vector<std::vector<Index>> coupled = joints::coupled_nodes(attachments.joints);
  std::ranges::transform(attachments.bows, std::back_inserter(coupled), &mesh::Patch::nodes);
  return coupled;
}

mesh::Patch owned(const mesh::Patch& patch, const mesh::Part& part) {
  mesh::Patch mine;
  const mesh::LocalNumbers numbers(part);
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    if (numbers.owns(patch.nodes[i])) {
      mine.nodes.push_back(numbers.of(patch.nodes[i]));
      if (!patch.shares.empty()) {
        mine.shares.push_back(patch.shares[i]);
      }
    }
  }
  return mine;
}

}  // namespace idiophone::motion

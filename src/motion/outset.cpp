#include "idiophone/motion/outset.hpp"

#include <algorithm>

#include "idiophone/motion/static_equilibrium.hpp"

namespace idiophone::motion {

namespace {

/// Values without pointers of their own, sent as bytes: the ranks of a job run the same binary.
template <class Value>
void broadcast_values(std::vector<Value>& values, MPI_Comm communicator) {
  auto count = static_cast<std::int64_t>(values.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, communicator);
  values.resize(static_cast<std::size_t>(count));
  MPI_Datatype value_type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(sizeof(Value), MPI_BYTE, &value_type);
  MPI_Type_commit(&value_type);
  MPI_Bcast(values.data(), static_cast<int>(count), value_type, 0, communicator);
  MPI_Type_free(&value_type);
}

}  // namespace

double Outset::stable_step() const {
  return std::ranges::min_element(steps, {}, &StableStep::step)->step;
}

Outset find_outset(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes, const Attachments& attachments) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  const Dynamics dynamics(scene, whole, attachments);
  Outset outset;
  for (const mesh::BodyPart& body : whole.bodies) {
    double mass = 0.0;
    Vector3 moment = Vector3::Zero();
    for (auto node = static_cast<std::size_t>(body.owned_begin); node < static_cast<std::size_t>(body.owned_end);
         ++node) {
      mass += dynamics.mass()[node];
      moment += dynamics.mass()[node] * whole.reference[node];
    }
    outset.masses.push_back(mass);
    outset.centres.emplace_back(moment / mass);
  }
  outset.steps = find_stable_steps(scene, whole, dynamics);
  outset.displacement = static_equilibrium(scene, whole, attachments, dynamics);
  return outset;
}

Outset broadcast(Outset outset, MPI_Comm communicator) {
  broadcast_values(outset.steps, communicator);
  broadcast_values(outset.masses, communicator);
  broadcast_values(outset.centres, communicator);
  broadcast_values(outset.displacement, communicator);
  return outset;
}

}  // namespace idiophone::motion

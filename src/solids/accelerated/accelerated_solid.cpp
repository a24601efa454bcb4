#include "idiophone/solids/accelerated/accelerated_solid.hpp"

#include <algorithm>

#include "element_tables.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::accelerated {

using accelerator::Array;
using parallel::ArchiveRow;

namespace {

constexpr std::size_t width = 4;  ///< numbers of a node in displacements and velocities: kernels read four at once

std::vector<Index> regions_of(const mesh::BodyPart& body) {
  std::vector<Index> result;
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    result.push_back(body.region(element));
  }
  return result;
}

std::vector<double> inverse(std::span<const double> masses) {
  std::vector<double> result;
  std::ranges::transform(masses, std::back_inserter(result), [](double mass) { return 1.0 / mass; });
  return result;
}

/// Bits of the components of each owned node.
/// @param begin  the first owned node
std::vector<int> held_bits(std::span<const Index> components, Index begin, Index owned) {
  std::vector<int> bits(owned);
  for (const Index component : components) {
    bits[component / 3 - begin] |= 1 << component % 3;
  }
  return bits;
}

}  // namespace

struct AcceleratedSolid::Device {
  Device(accelerator::Accelerator& its_accelerator, const mesh::BodyPart& body, const solid::Solid& solid,
         const LawSize& law, double step, const std::vector<Index>& regions, const std::vector<Index>& its_nodes,
         const GeometryTable& geometry_of, const NodeElements& elements, Index all_nodes,
         std::span<const double> inverse_masses, std::span<const int> held_components)
      : accelerator(its_accelerator),
        kernels(accelerator, body.element, law),
        mechanisms(law.mechanisms),
        points(body.element_ids.size() * element::reference(body.element).quadrature.size()),
        nodes(accelerator, its_nodes),
        region(accelerator, regions),
        first_geometry(accelerator, geometry_of.first),
        geometry(accelerator, geometry_of.values),
        materials(accelerator, material_table(solid, law, step)),
        first_place(accelerator, elements.first),
        places(accelerator, elements.places),
        inverse_mass(accelerator, inverse_masses),
        held(accelerator, held_components),
        displacement(accelerator, width * all_nodes),
        velocity(accelerator, width * all_nodes),
        memory(accelerator, 6UL * mechanisms * points),
        flux(accelerator, 9 * points) {}

  accelerator::Accelerator& accelerator;
  SolidKernels kernels;
  int mechanisms;
  std::size_t points;  ///< quadrature points of all elements
  Array<Index> nodes, region, first_geometry;
  Array<double> geometry, materials;
  Array<Index> first_place, places;
  Array<double> inverse_mass;
  Array<int> held;
  Array<double> displacement, velocity;  ///< [owned nodes of the body, then ghosts][4]
  Array<double> memory;                  ///< [mechanisms][6][points]
  Array<double> flux;                    ///< [9][points]
};

AcceleratedSolid::AcceleratedSolid(accelerator::Accelerator& accelerator, const mesh::BodyPart& body,
                                   std::span<const Vector3> reference, const solid::Solid& solid,
                                   const solid::Mass& mass, std::span<const Index> held, double step)
    : begin_(body.owned_begin), owned_(body.owned_end - body.owned_begin), step_(step), regions_(regions_of(body)) {
  find_borders(body);
  std::vector<Index> nodes;
  std::ranges::transform(body.elements, std::back_inserter(nodes), [this](Index node) { return number(node); });
  device_ = std::make_unique<Device>(accelerator, body, solid, law_size(solid), step, regions_, nodes,
                                     geometry_table(body, reference), node_elements(nodes, owned_),
                                     owned_ + static_cast<Index>(ghosts_.size()), inverse(mass.lumped()),
                                     held_bits(held, begin_, owned_));
}

AcceleratedSolid::~AcceleratedSolid() = default;

void AcceleratedSolid::find_borders(const mesh::BodyPart& body) {
  const auto is_own = [this](Index node) { return owns(node); };
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    const std::span<const Index> nodes = body.element_nodes(element);
    if (std::ranges::all_of(nodes, is_own)) {
      continue;
    }
    for (const Index node : nodes) {
      (is_own(node) ? shared_ : ghosts_).push_back(node);
    }
  }
  keep_each_once(ghosts_);
  keep_each_once(shared_);
}

Index AcceleratedSolid::number(Index node) const {
  if (owns(node)) {
    return node - begin_;
  }
  return owned_ + static_cast<Index>(std::ranges::lower_bound(ghosts_, node) - ghosts_.begin());
}

const Array<double>& AcceleratedSolid::displacements() const {
  return device_->displacement;
}

NodeList AcceleratedSolid::list(std::vector<Index> nodes) const {
  std::vector<Index> numbers;
  std::ranges::transform(nodes, std::back_inserter(numbers), [this](Index node) { return number(node); });
  return {device_->accelerator, std::move(nodes), numbers};
}

void AcceleratedSolid::load(std::span<const solid::NodeState> state, solid::Solid& solid) {
  std::vector<double> displacement(device_->displacement.size()), velocity(displacement.size());
  const auto put = [&](Index node) {
    std::copy_n(state[node].displacement, 3, &displacement[width * number(node)]);
    std::copy_n(state[node].velocity, 3, &velocity[width * number(node)]);
  };
  for (Index node = begin_; node < begin_ + owned_; ++node) {
    put(node);
  }
  std::ranges::for_each(ghosts_, put);
  device_->displacement.write(displacement);
  device_->velocity.write(velocity);
  load_memory(solid);
}

void AcceleratedSolid::save(std::span<solid::NodeState> state) const {
  std::vector<double> displacement(width * owned_), velocity(width * owned_);
  device_->displacement.read(displacement);
  device_->velocity.read(velocity);
  for (Index node = 0; node < owned_; ++node) {
    std::copy_n(&displacement[width * node], 3, state[begin_ + node].displacement);
    std::copy_n(&velocity[width * node], 3, state[begin_ + node].velocity);
  }
}

/// Calls visit(place in the memory of the accelerator, number) for all that an element remembers, in the order of
/// solid::Solid::archive_memory.
template <class Visitor>
void AcceleratedSolid::for_each_overstrain(const solid::Solid& solid, std::size_t element, Visitor visit) const {
  const std::size_t points = device_->points / regions_.size();
  const std::size_t numbers = 6 * solid.relaxation(regions_[element]).mechanisms.size();
  for (std::size_t point = 0; point < points; ++point) {
    for (std::size_t number = 0; number < numbers; ++number) {
      visit(number * device_->points + element * points + point, point * numbers + number);
    }
  }
}

void AcceleratedSolid::load_memory(solid::Solid& solid) {
  std::vector<double> memory(device_->memory.size());
  std::vector<double> numbers(memory.size() / std::max<std::size_t>(1, regions_.size()));
  for (std::size_t element = 0; element < regions_.size(); ++element) {
    ArchiveRow of_element(ArchiveRow::Action::save, numbers);
    solid.archive_memory(element, of_element);
    for_each_overstrain(solid, element,
                        [&](std::size_t place, std::size_t number) { memory[place] = numbers[number]; });
  }
  device_->memory.write(memory);
}

void AcceleratedSolid::save_memory(solid::Solid& solid) const {
  std::vector<double> memory(device_->memory.size());
  std::vector<double> numbers(memory.size() / std::max<std::size_t>(1, regions_.size()));
  device_->memory.read(memory);
  for (std::size_t element = 0; element < regions_.size(); ++element) {
    for_each_overstrain(solid, element,
                        [&](std::size_t place, std::size_t number) { numbers[number] = memory[place]; });
    ArchiveRow of_element(ArchiveRow::Action::restore, numbers);
    solid.archive_memory(element, of_element);
  }
}

void AcceleratedSolid::read(NodeList& list, std::span<solid::NodeState> state) const {
  const std::size_t count = list.nodes.size();
  device_->kernels.gather_motion({6 * count, 1, 1}, static_cast<int>(count), list.numbers_there, device_->displacement,
                                 device_->velocity, list.values_there);
  list.values_there.read(list.values);
  for (std::size_t i = 0; i < count; ++i) {
    solid::NodeState& node = state[list.nodes[i]];
    std::copy_n(&list.values[6 * i], 3, node.displacement);
    std::copy_n(&list.values[6 * i + 3], 3, node.velocity);
  }
}

void AcceleratedSolid::write(NodeList& list, std::span<const solid::NodeState> state) {
  const std::size_t count = list.nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const solid::NodeState& node = state[list.nodes[i]];
    std::copy_n(node.displacement, 3, &list.values[6 * i]);
    std::copy_n(node.velocity, 3, &list.values[6 * i + 3]);
  }
  list.values_there.write(list.values);
  device_->kernels.scatter_motion({6 * count, 1, 1}, static_cast<int>(count), list.numbers_there, list.values_there,
                                  device_->displacement, device_->velocity);
}

void AcceleratedSolid::find_stress() {
  Device& on = *device_;
  on.kernels.stress_points({on.points, 1, 1}, static_cast<int>(on.points), on.nodes, on.region, on.first_geometry,
                           on.geometry, on.materials, step_, on.displacement, on.velocity, on.memory, on.flux);
}

void AcceleratedSolid::advance(const solid::Kick& kick, Displacements displacements) {
  Device& on = *device_;
  on.kernels.advance_nodes({static_cast<std::size_t>(owned_), 1, 1}, owned_, static_cast<int>(on.points),
                           on.first_place, on.places, on.flux, on.inverse_mass, on.held, kick.keep, kick.gain,
                           kick.gravity[0], kick.gravity[1], kick.gravity[2],
                           displacements == Displacements::follow ? step_ : 0.0, on.velocity, on.displacement);
}

void AcceleratedSolid::push(NodeList& list, const solid::Kick& kick, std::span<const solid::NodeForce> force) {
  const std::size_t count = list.nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(force[list.nodes[i]].component, 3, &list.values[3 * i]);
  }
  list.values_there.write(std::span<const double>(list.values).first(3 * count));
  device_->kernels.push_nodes({count, 1, 1}, static_cast<int>(count), list.numbers_there, list.values_there,
                              device_->inverse_mass, device_->held, kick.gain, device_->velocity);
}

void AcceleratedSolid::displace() {
  device_->kernels.displace_nodes({static_cast<std::size_t>(owned_), 1, 1}, owned_, step_, device_->velocity,
                                  device_->displacement);
}

}  // namespace idiophone::accelerated

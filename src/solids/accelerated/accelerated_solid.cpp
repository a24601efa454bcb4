#include "idiophone/solids/accelerated/accelerated_solid.hpp"

#include <algorithm>

#include "element_tables.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"
#include "table_entries.hpp"

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

/// Bits of the components of each owned node.
/// @param begin  the first owned node
std::vector<int> held_bits(std::span<const Index> components, Index begin, Index owned) {
  std::vector<int> bits(owned);
  for (const Index component : components) {
    bits[component / 3 - begin] |= 1 << component % 3;
  }
  return bits;
}

std::vector<ElementEntry> element_entries(std::span<const Index> regions, const GeometryTable& geometry) {
  std::vector<ElementEntry> entries;
  std::ranges::transform(regions, geometry.first, std::back_inserter(entries), [](Index region, Index first) {
    return ElementEntry{region, first};
  });
  return entries;
}

std::vector<NodeEntry> node_entries(std::span<const double> masses, const NodeElements& elements,
                                    const std::vector<int>& held) {
  std::vector<NodeEntry> entries;
  for (std::size_t node = 0; node < held.size(); ++node) {
    entries.push_back({1.0 / masses[node], elements.first[node], held[node]});
  }
  entries.push_back({0.0, elements.first.back(), 0});
  return entries;
}

}  // namespace

struct AcceleratedSolid::Device {
  Device(accelerator::Accelerator& its_accelerator, const mesh::BodyPart& body, const solid::Solid& solid,
         const LawSize& law, double step, const std::vector<Index>& regions, const std::vector<Index>& its_nodes,
         const GeometryTable& geometry_of, const NodeElements& elements_of_nodes, Index with_ghosts,
         std::span<const double> masses, const std::vector<int>& held_components)
      : accelerator(its_accelerator),
        kernels(accelerator, body.element, law),
        mechanisms(law.mechanisms),
        points(body.element_ids.size() * element::reference(body.element).quadrature.size()),
        all_nodes(with_ghosts),
        nodes(accelerator, its_nodes),
        elements(accelerator, element_entries(regions, geometry_of)),
        geometry(accelerator, geometry_of.values),
        materials(accelerator, material_table(solid, law, step)),
        node_table(accelerator, node_entries(masses, elements_of_nodes, held_components)),
        places(accelerator, elements_of_nodes.places),
        motion(accelerator, 2 * width * all_nodes),
        memory(accelerator, 6UL * mechanisms * points),
        flux(accelerator, 9 * points) {}

  accelerator::Accelerator& accelerator;
  SolidKernels kernels;
  int mechanisms;
  std::size_t points;  ///< quadrature points of all elements
  Index all_nodes;     ///< owned ones of the body, and ghosts
  Array<Index> nodes;
  Array<ElementEntry> elements;
  Array<double> geometry, materials;
  Array<NodeEntry> node_table;
  Array<Index> places;
  Array<double> motion;  ///< [displacements, velocities][owned nodes of the body, then ghosts][4]
  Array<double> memory;  ///< [mechanisms][6][points]
  Array<double> flux;    ///< [9][points]
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
                                     owned_ + static_cast<Index>(ghosts_.size()), mass.lumped(),
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
  return device_->motion;
}

NodeList AcceleratedSolid::list(std::vector<Index> nodes) const {
  std::vector<Index> numbers;
  std::ranges::transform(nodes, std::back_inserter(numbers), [this](Index node) { return number(node); });
  return {device_->accelerator, std::move(nodes), numbers};
}

void AcceleratedSolid::load(std::span<const solid::NodeState> state, solid::Solid& solid) {
  std::vector<double> motion(device_->motion.size());
  const std::span<double> velocity = std::span(motion).subspan(width * device_->all_nodes);
  const auto put = [&](Index node) {
    std::copy_n(state[node].displacement, 3, &motion[width * number(node)]);
    std::copy_n(state[node].velocity, 3, &velocity[width * number(node)]);
  };
  for (Index node = begin_; node < begin_ + owned_; ++node) {
    put(node);
  }
  std::ranges::for_each(ghosts_, put);
  device_->motion.write(motion);
  load_memory(solid);
}

void AcceleratedSolid::save(std::span<solid::NodeState> state) const {
  std::vector<double> displacement(width * owned_), velocity(width * owned_);
  device_->motion.read(displacement);
  device_->motion.read(velocity, width * device_->all_nodes);
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
  device_->kernels.gather_motion({6 * count, 1, 1}, static_cast<int>(count), device_->all_nodes, list.numbers_there,
                                 device_->motion, list.values_there);
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
  device_->kernels.scatter_motion({6 * count, 1, 1}, static_cast<int>(count), device_->all_nodes, list.numbers_there,
                                  list.values_there, device_->motion);
}

void AcceleratedSolid::find_stress() {
  Device& on = *device_;
  on.kernels.stress_points({on.points, 1, 1}, static_cast<int>(on.points), on.all_nodes, on.nodes, on.elements,
                           on.geometry, on.materials, step_, on.motion, on.memory, on.flux);
}

void AcceleratedSolid::advance(const solid::Kick& kick, Displacements displacements) {
  Device& on = *device_;
  on.kernels.advance_nodes({static_cast<std::size_t>(owned_), 1, 1}, owned_, on.all_nodes, static_cast<int>(on.points),
                           on.node_table, on.places, on.flux, kick.keep, kick.gain, kick.gravity[0], kick.gravity[1],
                           kick.gravity[2], displacements == Displacements::follow ? step_ : 0.0, on.motion);
}

void AcceleratedSolid::push(NodeList& list, const solid::Kick& kick, std::span<const solid::NodeForce> force) {
  const std::size_t count = list.nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(force[list.nodes[i]].component, 3, &list.values[3 * i]);
  }
  list.values_there.write(std::span<const double>(list.values).first(3 * count));
  device_->kernels.push_nodes({count, 1, 1}, static_cast<int>(count), device_->all_nodes, list.numbers_there,
                              list.values_there, device_->node_table, kick.gain, device_->motion);
}

void AcceleratedSolid::displace() {
  device_->kernels.displace_nodes({static_cast<std::size_t>(owned_), 1, 1}, owned_, device_->all_nodes, step_,
                                  device_->motion);
}

}  // namespace idiophone::accelerated

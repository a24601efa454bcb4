#include "accelerator_losses.hpp"

#include <algorithm>

namespace idiophone::waves {

namespace {

/// Of a member of the ways.
template <class T>
accelerator::Array<T> array_of(accelerator::Accelerator& accelerator, const std::vector<WallLosses::Way>& ways,
                               T WallLosses::Way::*member) {
  std::vector<T> values;
  for (const WallLosses::Way& way : ways) {
    values.push_back(way.*member);
  }
  return {accelerator, std::span<const T>(values)};
}

std::vector<Index> first_ways(const std::vector<WallLosses::Way>& ways, Index nodes) {
  std::vector<Index> first;
  for (Index node = 0; node <= nodes; ++node) {
    const auto found = std::ranges::lower_bound(ways, node, {}, &WallLosses::Way::node);
    first.push_back(static_cast<Index>(found - ways.begin()));
  }
  return first;
}

std::vector<Index> places(const std::vector<Index>& cooled, Index nodes) {
  std::vector<Index> places(nodes, -1);
  for (std::size_t i = 0; i < cooled.size(); ++i) {
    places[cooled[i]] = static_cast<Index>(i);
  }
  return places;
}

}  // namespace

AcceleratorHalfDerivative::AcceleratorHalfDerivative(accelerator::Accelerator& accelerator, const HalfDerivative& from)
    : quantities(static_cast<int>(from.length())),
      all_weights(from.all_weights()),
      weights(accelerator, from.weights()),
      paces(accelerator, from.paces()),
      ratios(accelerator, from.ratios()),
      past(accelerator, HalfDerivative::terms * from.length()) {
  for (std::size_t term = 0; term < HalfDerivative::terms; ++term) {
    past.write(from.past(term), term * quantities);
  }
}

void AcceleratorHalfDerivative::save(HalfDerivative& to) const {
  for (std::size_t term = 0; term < HalfDerivative::terms; ++term) {
    past.read(to.past(term), term * quantities);
  }
}

AcceleratorLosses::AcceleratorLosses(WaveKernels& kernels, const WallLosses& losses, int cells, Index nodes)
    : kernels_(kernels),
      cells_(cells),
      nodes_(nodes),
      ways_(static_cast<int>(losses.ways().size())),
      friction_(kernels.program.accelerator(), losses.friction()),
      heat_(kernels.program.accelerator(), losses.heat()),
      node_(array_of(kernels.program.accelerator(), losses.ways(), &WallLosses::Way::node)),
      other_(array_of(kernels.program.accelerator(), losses.ways(), &WallLosses::Way::other)),
      weight_(array_of(kernels.program.accelerator(), losses.ways(), &WallLosses::Way::weight)),
      flow_(kernels.program.accelerator(), losses.flow()),
      slowed_(kernels.program.accelerator(), losses.ways().size()),
      first_way_(kernels.program.accelerator(), first_ways(losses.ways(), nodes)),
      place_in_cooled_(kernels.program.accelerator(), places(losses.cooled(), nodes)) {}

void AcceleratorLosses::take(const accelerator::Array<float>& pressure, accelerator::Array<float>& rate,
                             accelerator::Array<float>& change, Past past) {
  const int advances = past == Past::advances ? 1 : 0;
  const accelerator::Range of_nodes = {static_cast<std::size_t>(nodes_), 1, 1};
  kernels_.slow_ways({static_cast<std::size_t>(ways_), 1, 1}, ways_, friction_.quantities, cells_, advances,
                     friction_.all_weights, friction_.weights, friction_.paces, friction_.ratios, node_, other_,
                     pressure, flow_, friction_.past, slowed_);
  kernels_.slow_nodes(of_nodes, nodes_, first_way_, weight_, slowed_, rate);
  kernels_.cool_nodes(of_nodes, nodes_, heat_.quantities, cells_, advances, heat_.all_weights, heat_.weights,
                      heat_.paces, heat_.ratios, place_in_cooled_, pressure, rate, heat_.past, change);
}

void AcceleratorLosses::save(WallLosses& losses) const {
  flow_.read(losses.flow());
  friction_.save(losses.friction());
  heat_.save(losses.heat());
}

}  // namespace idiophone::waves

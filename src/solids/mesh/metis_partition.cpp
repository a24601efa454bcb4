#include "metis_partition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::mesh {

namespace {

/// One partition by METIS.
/// @param method  METIS_PTYPE_KWAY or METIS_PTYPE_RB (recursive bisection)
/// @param cuts    partitions that METIS makes; it takes the one with the fewest links between ranks
/// @return the rank of each vertex
std::vector<idx_t> one_partition(ElementLists& lists, idx_t ranks, mptype_et method, idx_t seed, idx_t cuts) {
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_PTYPE] = method;
  options[METIS_OPTION_NCUTS] = cuts;
  auto elements = static_cast<idx_t>(lists.begins.size() - 1);
  auto nodes = static_cast<idx_t>(lists.weights.size());
  idx_t cut = 0;
  std::vector<idx_t> element_parts(lists.begins.size() - 1);
  std::vector<idx_t> node_parts(lists.weights.size());
  const int status =
      METIS_PartMeshNodal(&elements, &nodes, lists.begins.data(), lists.nodes.data(), lists.weights.data(), nullptr,
                          &ranks, nullptr, options.data(), &cut, element_parts.data(), node_parts.data());
  if (status != METIS_OK) {
    throw std::runtime_error(fmt::format("METIS can't partition {} nodes and {} elements into {} (its status is {}{})",
                                         nodes, elements, ranks, status,
                                         status == METIS_ERROR_MEMORY ? ": out of memory" : ""));
  }
  return node_parts;
}

/// Work of the busiest rank: it computes all elements that touch a vertex of its own.
std::size_t largest_work(const ElementLists& lists, const std::vector<idx_t>& parts, idx_t ranks) {
  std::vector<std::size_t> work(ranks);
  std::vector<idx_t> touched;
  for (std::size_t element = 0; element + 1 < lists.begins.size(); ++element) {
    const idx_t begin = lists.begins[element];
    const idx_t end = lists.begins[element + 1];
    touched.clear();
    for (idx_t place = begin; place < end; ++place) {
      touched.push_back(parts[lists.nodes[place]]);
    }
    keep_each_once(touched);
    for (const idx_t rank : touched) {
      work[rank] += lists.work[element];
    }
  }
  return std::ranges::max(work);
}

}  // namespace

std::vector<idx_t> metis_parts(ElementLists lists, idx_t ranks) {
  constexpr std::size_t few = 50000;
  if (lists.weights.size() >= few) {
    return one_partition(lists, ranks, METIS_PTYPE_KWAY, 1, 1);
  }
  std::vector<idx_t> best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const auto consider = [&](std::vector<idx_t> parts) {
    if (const std::size_t work = largest_work(lists, parts, ranks); work < least) {
      least = work;
      best = std::move(parts);
    }
  };
  for (const mptype_et method : {METIS_PTYPE_KWAY, METIS_PTYPE_RB}) {
    consider(one_partition(lists, ranks, method, 1, 10));
    for (idx_t seed = 2; seed <= 10; ++seed) {
      consider(one_partition(lists, ranks, method, seed, 1));
    }
  }
  return best;
}

}  // namespace idiophone::mesh

#include "idiophone/air/waves/wave_field.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "absorbing_layer.hpp"
#include "flush_to_zero.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "transfer.hpp"
#include "wall_losses.hpp"

namespace idiophone::waves {

WaveField::WaveField(const Slab& slab, double courant, MPI_Comm communicator, const std::optional<LossyAir>& lossy)
    : slab_(slab),
      courant_(static_cast<float>(courant)),
      lossy_(lossy),
      cut_cells_(slab),
      pressure_(slab.length()),
      rate_(slab.length()) {
  MPI_Comm_dup(communicator, &communicator_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      layers_.emplace_back(slab, axis, end, courant_);
    }
  }
}

WaveField::~WaveField() {
  MPI_Comm_free(&communicator_);
}

void WaveField::set_surfaces(CutCells cut_cells) {
  transfer(slab_, {cut_cells_, pressure_, rate_, node_rate_}, cut_cells);
  const CutCells before = std::exchange(cut_cells_, std::move(cut_cells));
  if (lossy_) {
    renew_losses(before);
  }
  publish_nodes();
  exchange();
}

void WaveField::renew_losses(const CutCells& before) {
  auto losses = std::make_unique<WallLosses>(slab_, cut_cells_, *lossy_, courant_, communicator_);
  losses->rest(pressure_);
  if (losses_) {
    losses->take_past(cut_cells_, *losses_, before);
  }
  losses_ = std::move(losses);
}

void WaveField::step(std::span<const float> sources) {
  const FlushToZero flush;
  update_node_rates(sources);
  // A plane's pressures advance as soon as its upper neighbour has read them, while they are in the cache.
  for (int z = slab_.begin(); z < slab_.end(); ++z) {
    for (AbsorbingLayer& layer : layers_) {
      layer.add(z, pressure_, rate_);
    }
    update_plane_rates(z);
    if (z > slab_.begin()) {
      advance_plane(z - 1);
    }
  }
  advance_plane(slab_.end() - 1);
  advance_nodes();
  publish_nodes();
  exchange();
}

float WaveField::inflow(Index node) const {
  const float here = pressure_[slab_.length() + node];
  const Link* const links = cut_cells_.links().data();
  const auto [first, last] = cut_cells_.links_of(node);
  float flow = 0.0F;
  for (const Link* link = links + first; link != links + last; ++link) {
    flow += link->area * (pressure_[link->to] - here);
  }
  return courant_ * courant_ / cut_cells_.nodes()[node].volume * flow;
}

void WaveField::update_node_rates(std::span<const float> sources) {
  for (Index node = cut_cells_.first_node(slab_.begin()); node < cut_cells_.first_node(slab_.end()); ++node) {
    node_rate_[node] += inflow(node) + sources[node];
  }
  if (losses_) {
    losses_->slow(pressure_, node_rate_);
  }
}

void WaveField::forecast(std::span<float> pressures) {
  const FlushToZero flush;
  const Index first = cut_cells_.first_node(slab_.begin()), last = cut_cells_.first_node(slab_.end());
  for (Index node = first; node < last; ++node) {
    pressures[node] = node_rate_[node] + inflow(node);
  }
  if (losses_) {
    losses_->slow(pressure_, pressures);
    losses_->cool(pressure_, pressures);
  }
  for (Index node = first; node < last; ++node) {
    pressures[node] = pressure_[slab_.length() + node] + pressures[node] / 2.0F;
  }
}

void WaveField::update_plane_rates(int z) {
  const float square = courant_ * courant_;
  const Index row = slab_.row_length();
  const Index plane = slab_.plane_length();
  const int length = slab_.grid().cells[0];
  for (int y = 0; y < slab_.grid().cells[1]; ++y) {
    const Index first = slab_.number(0, y, z);
    const float* const here = &pressure_[first];
    float* const __restrict rate = &rate_[first];
    for (int x = 0; x < length; ++x) {
      const float p = here[x];
      const float along_x = (here[x - 1] - p) + (here[x + 1] - p);
      const float along_y = (here[x - row] - p) + (here[x + row] - p);
      const float along_z = (here[x - plane] - p) + (here[x + plane] - p);
      rate[x] += square * ((along_x + along_y) + along_z);
    }
  }
}

void WaveField::advance_plane(int z) {
  const int length = slab_.grid().cells[0];
  for (int y = 0; y < slab_.grid().cells[1]; ++y) {
    const Index first = slab_.number(0, y, z);
    float* const __restrict pressure = &pressure_[first];
    const float* const __restrict rate = &rate_[first];
    for (int x = 0; x < length; ++x) {
      pressure[x] += rate[x];
    }
  }
}

void WaveField::advance_nodes() {
  std::span<const float> change = node_rate_;
  if (losses_) {
    change_ = node_rate_;
    losses_->cool(pressure_, change_);
    losses_->advance();
    change = change_;
  }
  for (Index node = cut_cells_.first_node(slab_.begin()); node < cut_cells_.first_node(slab_.end()); ++node) {
    pressure_[slab_.length() + node] += change[node];
  }
}

void WaveField::publish_nodes() {
  const auto& nodes = cut_cells_.nodes();
  for (Index node = cut_cells_.first_node(slab_.end()) - 1; node >= cut_cells_.first_node(slab_.begin()); --node) {
    const auto& [x, y, z] = nodes[node].cell;  // backwards, so that the first of a cell remains
    pressure_[slab_.number(x, y, z)] = pressure_[slab_.length() + node];
    rate_[slab_.number(x, y, z)] = 0.0F;
  }
  for (const SolidRun& run : cut_cells_.solids()) {
    std::fill_n(&pressure_[run.first], run.length, 0.0F);
    std::fill_n(&rate_[run.first], run.length, 0.0F);
  }
}

void WaveField::exchange() {
  const int rank = parallel::rank_of(communicator_);
  const int ranks = parallel::size_of(communicator_);
  const int below = rank > 0 ? rank - 1 : MPI_PROC_NULL;
  const int above = rank + 1 < ranks ? rank + 1 : MPI_PROC_NULL;
  std::array<MPI_Request, 8> requests{};
  int count = 0;
  const auto message = [&](int z, int other, bool sends) {
    const Index first_node = cut_cells_.first_node(z);
    const std::array parts = {
        std::span(&pressure_[slab_.number(0, -1, z)], slab_.plane_length()),
        std::span(pressure_).subspan(slab_.length() + first_node, cut_cells_.first_node(z + 1) - first_node)};
    for (int part = 0; part < 2; ++part) {
      const auto size = static_cast<int>(parts.at(part).size());
      if (sends) {
        MPI_Isend(parts.at(part).data(), size, MPI_FLOAT, other, part, communicator_, &requests.at(count++));
      } else {
        MPI_Irecv(parts.at(part).data(), size, MPI_FLOAT, other, part, communicator_, &requests.at(count++));
      }
    }
  };
  message(slab_.begin() - 1, below, false);
  message(slab_.end(), above, false);
  message(slab_.begin(), below, true);
  message(slab_.end() - 1, above, true);
  MPI_Waitall(count, requests.data(), MPI_STATUSES_IGNORE);
  if (slab_.grid().rigid_below && slab_.begin() == 0) {  // the mirror image
    std::copy_n(&pressure_[slab_.number(0, 0, 0)], slab_.plane_length(), &pressure_[slab_.number(0, 0, -1)]);
  }
}

void WaveField::archive(parallel::Archive& archive) {
  archive_planes(archive);
  archive_nodes(archive);
  if (losses_) {
    losses_->archive(archive);
  }
  if (archive.restoring()) {
    exchange();
  }
}

void WaveField::archive_planes(parallel::Archive& archive) {
  std::vector<std::int32_t> planes(slab_.end() - slab_.begin());
  std::iota(planes.begin(), planes.end(), slab_.begin());
  const parallel::Rows rows(planes, slab_.grid().cells[2], communicator_);
  archive.rows("waves/planes", rows, [this](std::size_t plane, parallel::ArchiveRow& row) {
    const int z = slab_.begin() + static_cast<int>(plane);
    for (int y = 0; y < slab_.grid().cells[1]; ++y) {
      const Index first = slab_.number(0, y, z);
      row.values(std::span(&pressure_[first], slab_.grid().cells[0]));
      row.values(std::span(&rate_[first], slab_.grid().cells[0]));
    }
    for (AbsorbingLayer& layer : layers_) {
      layer.archive(z, row);
    }
  });
}

void WaveField::archive_nodes(parallel::Archive& archive) {
  const Index first = cut_cells_.first_node(slab_.begin());
  const Index own = cut_cells_.first_node(slab_.end()) - first;
  const std::vector<Index> counts = parallel::gather(own, communicator_);
  const auto here = counts.begin() + parallel::rank_of(communicator_);
  const Index before = std::accumulate(counts.begin(), here, Index{0});
  std::vector<std::int32_t> numbers(own);
  std::iota(numbers.begin(), numbers.end(), before);
  const parallel::Rows rows(numbers, std::accumulate(here, counts.end(), before), communicator_);
  archive.rows("waves/nodes", rows, [this, first](std::size_t node, parallel::ArchiveRow& row) {
    row.value(pressure_[slab_.length() + first + static_cast<Index>(node)]);
    row.value(node_rate_[first + static_cast<Index>(node)]);
  });
}

}  // namespace idiophone::waves

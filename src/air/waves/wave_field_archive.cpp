// What of a field a checkpoint keeps: rows of cells, layers and nodes, in the order of the whole grid.

#include <array>
#include <utility>
#include <vector>

#include "cell_rows.hpp"
#include "face_exchange.hpp"
#include "field_state.hpp"
#include "field_steps.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::waves {

void WaveField::archive(parallel::Archive& archive) {
  steps_->save();
  archive_cells(archive);
  archive_layers(archive);
  archive_nodes(archive);
  if (state_->losses) {
    state_->losses->archive(state_->cut_cells, archive);
  }
  if (archive.restoring()) {
    exchange();
    steps_->load();
  }
}

void WaveField::archive_cells(parallel::Archive& archive) {
  const Subdomain& subdomain = state_->subdomain;
  const CellBox all = row_pieces(subdomain.grid().all());
  const CellBox own = row_pieces(subdomain.cells());
  std::vector<std::int32_t> numbers;
  for_each_cell(
      own, [&](const std::array<int, 3>& piece) { numbers.push_back(static_cast<std::int32_t>(all.place(piece))); });
  const parallel::Rows rows(numbers, static_cast<std::int64_t>(all.size()), archive.communicator());
  archive.rows("waves/cells", rows, [&](std::size_t place, parallel::ArchiveRow& row) {
    std::array<int, 3> first = own.cell(place);
    first[0] *= Grid::row_multiple;
    row.values(std::span(state_->pressure).subspan(subdomain.number(first), Grid::row_multiple));
    row.values(std::span(state_->rate).subspan(subdomain.number(first), Grid::row_multiple));
  });
}

void WaveField::archive_layers(parallel::Archive& archive) {
  std::vector<std::pair<AbsorbingLayer*, std::size_t>> pieces;  // a layer, and the place among its rows
  std::vector<std::int32_t> numbers;
  for (CellUpdate& update : state_->updates) {
    for (AbsorbingLayer& layer : update.layers()) {
      const std::vector<std::int32_t> of_layer = layer.row_numbers();
      for (std::size_t place = 0; place < of_layer.size(); ++place) {
        pieces.emplace_back(&layer, place);
        numbers.push_back(of_layer[place]);
      }
    }
  }
  const parallel::Rows rows(numbers, AbsorbingLayer::archive_rows(state_->subdomain.grid()), archive.communicator());
  archive.rows("waves/layers", rows,
               [&](std::size_t i, parallel::ArchiveRow& row) { pieces[i].first->archive(pieces[i].second, row); });
}

void WaveField::archive_nodes(parallel::Archive& archive) {
  std::vector<std::array<int, 3>> cells;
  for (Index node = 0; node < state_->cut_cells.own_nodes(); ++node) {
    cells.push_back(state_->cut_cells.nodes()[node].cell);
  }
  const parallel::Rows rows = rows_by_cell(state_->subdomain.grid(), cells, archive.communicator());
  archive.rows("waves/nodes", rows, [this](std::size_t node, parallel::ArchiveRow& row) {
    row.value(state_->node_pressures()[node]);
    row.value(state_->node_rate[node]);
  });
}

}  // namespace idiophone::waves

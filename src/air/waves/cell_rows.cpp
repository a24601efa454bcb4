#include "cell_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::waves {

parallel::Rows rows_by_cell(const Grid& grid, const std::vector<std::array<int, 3>>& cells, MPI_Comm communicator) {
  std::vector<std::int64_t> own;
  for (const auto& cell : cells) {
    own.push_back(static_cast<std::int64_t>(grid.all().place(cell)));
  }
  auto all = parallel::gather_all(std::span<const std::int64_t>(own), communicator).values;
  std::ranges::sort(all);
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool same_cell = i > 0 && own[i] == own[i - 1];
    const auto first = std::ranges::lower_bound(all, own[i]) - all.begin();
    numbers.push_back(same_cell ? numbers.back() + 1 : static_cast<std::int32_t>(first));
  }
  return {numbers, std::ssize(all), communicator};
}

}  // namespace idiophone::waves

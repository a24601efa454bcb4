#include "views.hpp"

#include <fmt/format.h>
#include <gmsh.h>

namespace idiophone::mesher {

std::vector<mesh::ViewBlock> views() {
  std::vector<int> numbers;
  gmsh::view::getTags(numbers);
  std::vector<mesh::ViewBlock> blocks;
  for (const int number : numbers) {
    std::string type;
    std::vector<std::size_t> tags;
    std::vector<double> values;
    double time = 0.0, steps = 0.0;
    int components = 0;
    gmsh::view::getHomogeneousModelData(number, 0, type, tags, values, time, components);
    if (type != "NodeData" && type != "ElementData") {
      continue;
    }
    const std::string view = fmt::format("View[{}].", gmsh::view::getIndex(number));
    auto& block = blocks.emplace_back();
    gmsh::option::getString(view + "Name", block.name);
    gmsh::option::getNumber(view + "NbTimeStep", steps);
    block.of_elements = type == "ElementData" ? 1 : 0;
    block.steps = static_cast<std::int32_t>(steps);
    block.tags.assign(tags.begin(), tags.end());
    block.values = std::move(values);
  }
  return blocks;
}

}  // namespace idiophone::mesher

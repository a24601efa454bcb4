// All kinds of nodes that trees of the program can have.

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/timbre/body_nodes/body_nodes.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(NodeTypes, AreInTheDocumentation) {
  add_body_nodes();
  const std::string whole = deck::read_text(IDIOPHONE_SOURCE_DIR "/docs/use/timbre_trees.md");
  const std::string page = whole.substr(whole.find("## Nodes"));
  std::size_t rows = 0;
  for (std::size_t at = page.find("\n| `("); at != std::string::npos; at = page.find("\n| `(", at + 1)) {
    ++rows;
  }
  EXPECT_EQ(rows, node_types().size());
  for (const NodeType& type : node_types()) {
    const std::string row = "| `" + type.usage() + "` | " + type.description + " |\n";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(NodeTypes, CanBeAddedOnce) {
  add_body_nodes();
  EXPECT_NO_THROW(add_body_nodes());
  EXPECT_THROW(add_node_types({{.name = "proxy", .description = {}}}), std::invalid_argument);
  EXPECT_THROW(add_node_types({{.name = "pi", .description = {}}}), std::invalid_argument);
}

}  // namespace idiophone::timbre

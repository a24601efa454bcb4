#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idiophone/solids/mesh/mesh.hpp"

#include "ranks.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const deck::Location where = {.file = "deck.yaml", .line = 3, .column = 4};

std::string refusal_of_group(const Mesh& mesh, const std::string& group) {
  try {
    static_cast<void>(find_group(mesh, group, where));
    return "";
  } catch (const deck::DeckError& error) {
    return error.what();
  }
}

ON_RANKS(1);

TEST(FindGroup, FindsOrSaysWhatThereIs) {
  Mesh mesh;
  EXPECT_THAT(refusal_of_group(mesh, "rim"), HasSubstr("Physical Surface"));
  mesh.groups = {{"bottom", {1}}, {"rim", {2, 3}}, {"top", {4}}};
  EXPECT_EQ(find_group(mesh, "rim", where), (std::vector<Index>{2, 3}));
  EXPECT_THAT(refusal_of_group(mesh, "rimm"),
              AllOf(StartsWith("deck.yaml:3:4:"), HasSubstr("did you mean 'rim'?"), HasSubstr("bottom, rim, top")));
  EXPECT_THAT(refusal_of_group(mesh, "botom"), HasSubstr("did you mean 'bottom'?"));
}

}  // namespace
}  // namespace idiophone::mesh

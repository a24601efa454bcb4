// Tools, strips of a side, certainty and drawings of cuts.

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "block_mesh.hpp"
#include "certainty.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/face_shares.hpp"
#include "idiophone/study/bench/cut_drawing.hpp"
#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/bench/cut_plan.hpp"
#include "idiophone/study/bench/cuttable_mesh.hpp"
#include "nonnegative.hpp"

namespace idiophone::bench {
namespace {

using ::testing::HasSubstr;

std::string refusal_of_tools(const std::vector<std::string>& texts) {
  try {
    static_cast<void>(read_tools(texts));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Tools, AreReadOrRefused) {
  const std::vector<Tool> tools = read_tools({"router:0.006", "sander:0.02"});
  ASSERT_EQ(tools.size(), 2U);
  EXPECT_EQ(depth_share(tools[0], 0.0059), 1.0);
  EXPECT_EQ(depth_share(tools[0], -0.0061), 0.0);
  EXPECT_NEAR(depth_share(tools[1], 0.01), 0.5, 1e-12);
  EXPECT_EQ(depth_share(tools[1], 0.021), 0.0);
  for (const char* text :
       {"router", "router:", "router:-1", "router:0", "router:nan", "router:0.006m", "saw:0.01", ""}) {
    EXPECT_THAT(refusal_of_tools({text}), HasSubstr("is not a tool")) << text;
  }
  EXPECT_THAT(refusal_of_tools({}), HasSubstr("needs a tool"));
}

TEST(Tools, SuitTheBody) {
  EXPECT_NO_THROW(require_suitable_radii(read_tools({"router:0.00101", "sander:0.15"}), 0.3));
  const auto refusal = [](const char* tool) -> std::string {
    try {
      require_suitable_radii(read_tools({"router:0.006", tool}), 0.3);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("router:1e-9"),
            "--tools: router:1e-09 does not suit this body, which is 0.3 m long: its radius must be between 0.001 and "
            "0.15 m");
  EXPECT_THAT(refusal("sander:0.151"), HasSubstr("sander:0.151 does not suit"));
}

// Karush, Kuhn and Tucker's conditions make the solution certain.
TEST(NonnegativeLeastSquares, FulfilsTheConditionsOfTheLeast) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(3, 40, [&] { return uniform(random); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(3, [&] { return uniform(random); });
    const Eigen::MatrixXd negative = trial % 2 ? a : Eigen::MatrixXd(-a.cwiseAbs());
    const Eigen::VectorXd x = nonnegative_least_squares(negative, b);
    const Eigen::VectorXd gradient = negative.transpose() * (negative * x - b);
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_GE(gradient.minCoeff(), -1e-7);
    EXPECT_NEAR(gradient.dot(x), 0.0, 1e-9);
  }
}

TEST(Tools, NarrowerThanTheBodyAreDoubted) {
  std::vector<Tool> tools = read_tools({"router:0.003", "sander:0.02"});
  const std::vector<Tool> narrow = doubt_narrow_tools(tools, 0.007);
  ASSERT_EQ(narrow.size(), 1U);
  EXPECT_EQ(narrow[0].radius, 0.003);
  EXPECT_GT(tools[0].slope_error, 0.1);
  EXPECT_EQ(tools[1].slope_error, 0.0);
}

constexpr double length = 0.3, width = 0.05, height = 0.02;  // m

/// A block whose slopes are 1 and x, in cents/m3.
Strips strips_of_block(const std::string& side) {
  const mesh::Mesh mesh = support::block_mesh(element::hex(3, 2), {length, width, height}, {5, 1, 1});
  eigenmodes::RemovalSlopes removal;
  removal.slopes.resize(2);
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    removal.nodes.push_back(node);
    removal.slopes[0].push_back(1.0);
    removal.slopes[1].push_back(mesh.nodes[node].x());
  }
  return strips_of(mesh, removal, read_side(side, mesh));
}

TEST(Strips, AddUpToTheSide) {
  const Strips below = strips_of_block("");
  EXPECT_NEAR(below.slopes.row(0).sum(), length * width, 1e-12);
  EXPECT_NEAR(below.slopes.row(1).sum(), length * width * length / 2, 1e-12);
  EXPECT_NEAR(slopes_of(below, {"router", Profile::groove, 0.01}, 0.1)[1], 0.02 * width * 0.1, 5e-7);
  EXPECT_NEAR(strips_of_block("-y").slopes.row(0).sum(), length * height, 1e-12);
  EXPECT_THROW(static_cast<void>(strips_of_block("below")), std::runtime_error);
}

/// Volume between the outer surfaces of two meshes whose nodes differ in z, by the shape functions of their faces.
double volume_between(const mesh::Mesh& before, const mesh::Mesh& after) {
  double volume = 0.0;
  for_each_shared_face(before, [&](std::span<const mesh::ElementFace> shared) {
    if (shared.size() > 1) {
      return;
    }
    const std::vector<Vector3> areas = face_areas(before, shared.front());
    const auto& places = element::reference(before.element).faces[shared.front().side].nodes;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Index node = before.element_nodes(shared.front().element)[places[k]];
      volume += areas[k].z() * (before.nodes[node] - after.nodes[node]).z();
    }
  });
  return volume;
}

// Exact but for the sums over pieces of the surface.
TEST(CuttableMesh, LosesTheVolumeOfTheCuts) {
  const mesh::Mesh mesh = support::block_mesh(element::hex(3, 2), {length, width, height}, {5, 1, 1});
  const CuttableMesh cuttable(mesh, read_side("", mesh));
  const std::vector<Cut> cuts = {{{"router", Profile::groove, 0.003}, 0.11, 1e-3, {}},
                                 {{"sander", Profile::hollow, 0.02}, 0.2, 2e-3, {}}};
  const double removed = width * (0.006 * 1e-3 + 0.02 * 2e-3);
  const mesh::Mesh cut = cuttable.with(cuts);
  EXPECT_NEAR(volume_between(mesh, cut), removed, 0.02 * removed);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const Vector3 moved = cut.nodes[node] - mesh.nodes[node];
    EXPECT_EQ(moved.head<2>().norm(), 0.0);
    if (mesh.nodes[node].z() > height - 1e-9) {
      EXPECT_EQ(moved.z(), 0.0);
    }
  }
  EXPECT_THROW(static_cast<void>(cuttable.with({{{"sander", Profile::hollow, 0.04}, 0.15, 0.015, {}}})),
               std::runtime_error);
}

// By themselves, the partials would have to keep 13 and 1 cents.
TEST(Certainty, LeavesTheSameShareOfAllPartialsThatAreOutOfTune) {
  const PlanOptions options;
  const Certainty certainty({Eigen::Vector2d(40, -20), Eigen::Vector2d(0.5, 0.5), false}, options);
  const Eigen::Vector2d spread(6, 2);
  EXPECT_NEAR((certainty.to_leave(Eigen::Vector2d(40, -20), spread) - Eigen::Vector2d(13, -6.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((certainty.to_leave(Eigen::Vector2d(40, 2), spread) - Eigen::Vector2d(13, 1)).norm(), 0, 1e-12);
}

// The uncertainty of a line of the last tap lets a partial pass its target by 12 cents; that of one carried over does
// not.
TEST(Certainty, AllowsNothingForTheUncertaintyOfALineThatIsCarriedOver) {
  const PlanOptions options;
  const Eigen::Vector2d errors(40, 40), expected(2, 2), none(0, 0);
  const Certainty tapped({errors, Eigen::Vector2d(4, 4), false}, options);
  const Certainty carried({errors, Eigen::Vector2d(4, 4), false, {false, true}}, options);
  EXPECT_EQ(tapped.too_far(errors, expected, Eigen::Vector2d(4, 4)), none);
  EXPECT_NEAR((carried.too_far(errors, expected, Eigen::Vector2d(4, 4)) - Eigen::Vector2d(0, -5)).norm(), 0, 1e-12);
  EXPECT_TRUE(tapped.is_measured());
  EXPECT_FALSE(carried.is_measured());
  EXPECT_TRUE(Certainty({errors, Eigen::Vector2d(4, 1.6), false, {false, true}}, options).is_measured());
  // An interval above a first partial that is carried over is as uncertain as that one.
  EXPECT_FALSE(Certainty({errors, Eigen::Vector2d(4, 0.5), true, {true, false}}, options).is_measured());
}

TEST(Certainty, AsksThatNoPartialGoesAway) {
  const PlanOptions options;
  const Certainty certainty({Eigen::Vector2d(6, -20), Eigen::Vector2d(0.5, 0.5), false}, options);
  const Eigen::Vector2d errors(6, -20);
  EXPECT_TRUE(certainty.are_nearer(Eigen::Vector2d(6, -15), errors));
  EXPECT_FALSE(certainty.are_nearer(Eigen::Vector2d(7, -5), errors));
  EXPECT_TRUE(certainty.are_nearer(Eigen::Vector2d(2.9, -15), Eigen::Vector2d(1, -20)));
  EXPECT_FALSE(certainty.are_nearer(Eigen::Vector2d(6, -20), errors));
}

// Two blocks with 0.1 m between them.
TEST(Drawing, NamesTheGapOfABody) {
  mesh::Mesh mesh = support::block_mesh(element::hex(3, 2), {length, width, height}, {5, 1, 1});
  const Side side = read_side("", mesh);
  const std::vector<Cut> cuts = {{{"router", Profile::groove, 0.01}, 0.35, 1e-4, {}}};
  EXPECT_EQ(profile_of(mesh, side, {}).size(), 32U);
  const auto count = static_cast<Index>(mesh.nodes.size());
  for (Index node = 0; node < count; ++node) {
    mesh.nodes.push_back(mesh.nodes[node] + Vector3(length + 0.1, 0, 0));
  }
  const std::vector<mesh::Triangle> surface = mesh.surface;
  for (const auto& [a, b, c] : surface) {
    mesh.surface.push_back({a + count, b + count, c + count});
  }
  try {
    static_cast<void>(profile_of(mesh, side, cuts));
    FAIL() << "the gap is drawn";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nothing of the body lies between x = 0.3 and 0.34 m"));
  }
  EXPECT_THROW(static_cast<void>(profile_of(mesh, side, {})), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::bench

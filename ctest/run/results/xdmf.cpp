#include "xdmf.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>

#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What tools/check_xdmf prints about a file.
std::vector<std::string> check(const std::filesystem::path& xdmf) {
  const auto command = fmt::format("{}/tools/check_xdmf '{}' 2>&1", IDIOPHONE_SOURCE_DIR, xdmf.string());
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);  // NOLINT(cert-env33-c)
  std::vector<std::string> lines;
  std::array<char, 1000> line{};
  while (fgets(line.data(), line.size(), pipe.get()) != nullptr) {
    lines.emplace_back(line.data());
    lines.back().pop_back();
  }
  return lines;
}

/// What it should print about a body at a frame.
std::string expected(const TestBody& body, int frame) {
  const auto last = body.nodes() - 1;
  return fmt::format("{:.6f} {} {} {} {} {:.6f} {:.6f} {:.6f}", frame / 60.0, body.name,
                     body.type == element::tet10 ? "tetra10" : "tetra", body.elements, body.nodes(),
                     frame * value_of(last, 0), frame * value_of(last, 1), frame * value_of(last, 2));
}

std::string text_of(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

ON_RANKS(1, 3);

TEST(Xdmf, SeveralBodiesReadBack) {
  const Folder folder;
  make_result(folder / "plate & hammer.h5", 0);
  if (rank() == 0) {
    EXPECT_THAT(check(folder / "plate & hammer.xdmf"),
                ElementsAre(expected(hammer, 0), expected(hammer, 1), expected(hammer, 2), expected(plate, 0),
                            expected(plate, 1), expected(plate, 2)));
    EXPECT_THAT(text_of(folder / "plate & hammer.xdmf"), Not(HasSubstr(folder.path().string())));
  }
}

TEST(Xdmf, FollowsTheFrames) {
  const Folder folder;
  auto result = ResultFile::create(folder / "plate.h5", origin, MPI_COMM_WORLD);
  result.flush();
  barrier();
  EXPECT_FALSE(std::filesystem::exists(folder / "plate.xdmf"));
  barrier();
  add_mesh(result, plate, 1);
  result.flush();
  if (rank() == 0) {
    EXPECT_EQ(write_xdmf(folder / "plate.h5"), folder / "plate.xdmf");
    EXPECT_THAT(check(folder / "plate.xdmf"), ElementsAre(expected(plate, 0)));
  }
  barrier();
  const auto lengths = result.lengths();
  for (int frame = 0; frame < 2; ++frame) {
    add_frame(result, frame, 1, {plate});
    result.flush();
  }
  if (rank() == 0) {
    EXPECT_THAT(check(folder / "plate.xdmf"), ElementsAre(expected(plate, 0), expected(plate, 1)));
  }
  barrier();
  result.truncate(lengths);
  if (rank() == 0) {
    EXPECT_THAT(text_of(folder / "plate.xdmf"), Not(HasSubstr("displacement")));
  }
}

}  // namespace
}  // namespace idiophone::results

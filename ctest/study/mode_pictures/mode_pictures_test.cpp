#include "idiophone/study/mode_pictures/mode_pictures.hpp"

#include <gmock/gmock.h>

namespace idiophone::mode_pictures {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t place = text.find(part); place != std::string::npos; place = text.find(part, place + 1)) {
    ++found;
  }
  return found;
}

TEST(ModePictures, ShowTheSideThatIsSeenInTheColourOfItsMotion) {
  const std::vector<Vector3> nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<Index, 3>> both_sides = {{0, 1, 2}, {0, 2, 1}};  // upwards and downwards
  const std::vector<double> up = {0, 0, 1, 0, 0, 1, 0, 0, 1}, down = {0, 0, -1, 0, 0, -1, 0, 0, -1}, rest(9, 0.0);
  const std::string svg = svg_of_modes({nodes, both_sides}, {up, down, rest}, {"1: 100 Hz", "2: 200 Hz", "3: 300 Hz"});
  EXPECT_EQ(count(svg, "<path"), 3U) << "the lower side is hidden";
  EXPECT_THAT(svg, testing::HasSubstr(">2: 200 Hz<"));
  const auto red_and_blue = [&](int mode) {
    const std::size_t place = svg.find("fill=\"#", svg.find(std::to_string(mode) + ": ")) + 7;
    return std::pair(std::stoi(svg.substr(place, 2), nullptr, 16), std::stoi(svg.substr(place + 4, 2), nullptr, 16));
  };
  EXPECT_GT(red_and_blue(1).first, red_and_blue(1).second + 100);
  EXPECT_GT(red_and_blue(2).second, red_and_blue(2).first + 100);
  EXPECT_EQ(red_and_blue(3).first, red_and_blue(3).second);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(ModePictures, RefuseMeshesThatAreTooFine) {
  const std::vector<Vector3> nodes(3, Vector3::Zero());
  const std::vector<std::array<Index, 3>> many(most_triangles + 1, {0, 1, 2});
  EXPECT_THROW((void)svg_of_modes({nodes, many}, {std::vector<double>(9)}, {"1"}), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::mode_pictures

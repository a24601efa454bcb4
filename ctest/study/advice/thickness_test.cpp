#include "idiophone/study/advice/thickness.hpp"

#include <gtest/gtest.h>

#include "boxes.hpp"
#include "ranks.hpp"

namespace idiophone::advice {
namespace {

CrossSection section_of(const Surface& surface) {
  return smallest_cross_section(surface.triangles, surface.nodes);
}

ON_RANKS(1);

TEST(CrossSection, OfABarIsItsOwn) {
  Surface slender;
  add_box(slender, {0, 0, 0}, {0.0045, 0.006, 0.08}, 6);
  const CrossSection section = section_of(slender);
  EXPECT_NEAR(section.thickness, 0.0045, 2e-4);
  EXPECT_NEAR(section.width, 0.006, 2e-4);
}

TEST(CrossSection, OfAPlateIsWide) {
  Surface flat;
  add_box(flat, {0, 0, 0}, {0.3, 0.3, 0.006}, 6);
  EXPECT_NEAR(section_of(flat).thickness, 0.006, 1e-9);
  EXPECT_GT(section_of(flat).width, 0.06) << "the ways across its corners are the shortest";
}

TEST(CrossSection, IsThatOfTheThinnestPart) {
  Surface both;
  add_box(both, {0, 0, 0}, {0.1, 0.1, 0.1}, 4);
  add_box(both, {0.2, 0, 0}, {0.21, 0.012, 0.3}, 4);
  EXPECT_NEAR(section_of(both).thickness * section_of(both).width, 0.01 * 0.012, 1e-5);
}

TEST(LevelError, IsThatOfMeasuredBars) {
  const CrossSection tine{.thickness = 0.0045, .width = 0.006};
  EXPECT_NEAR(level_error(tine, 0.004), 5.3, 0.1);  // -1.8 to -4.4 dB by the test SlenderBar and finer cells
  EXPECT_NEAR(level_error(tine, 0.002), 1.3, 0.1);
  EXPECT_NEAR(level_error(tine, fine_cell(tine)), 0.5, 1e-12);
}

TEST(LevelError, OfASheetDoesNotDependOnItsThickness) {
  const CrossSection thin{.thickness = 0.0002, .width = 0.2}, thinner{.thickness = 0.00002, .width = 0.2};
  EXPECT_NEAR(level_error(thin, 0.008), 0.58, 0.01);  // 0.2 dB by the test Disc
  EXPECT_EQ(level_error(thin, 0.008), level_error(thinner, 0.008));
  EXPECT_NEAR(level_error(thin, fine_cell(thin)), 0.5, 1e-12);
}

TEST(LevelError, OfOppositePartsCoversMeasuredBars) {
  const CrossSection beam{.thickness = 0.0225, .width = 0.03};     // two of them, 7.5 mm apart: docs/method/waves.md
  const auto bound = [&](double cells_across, double frequency) {  // dB
    const double from = opposite_parts_from(beam, beam.thickness / cells_across, 343.0);
    return 20.0 * std::log10(1.0 + (std::pow(10.0, 3.0 / 20.0) - 1.0) * from / frequency);
  };
  EXPECT_GT(bound(3.5, 100.0), 1.7);
  EXPECT_GT(bound(3.5, 300.0), 0.4);
  EXPECT_GT(bound(1.1, 300.0), 6.0);
  EXPECT_GT(opposite_parts_from(beam, beam.thickness / 1.1, 343.0), 1000.0);  // 32 dB at 100 Hz
  EXPECT_LT(bound(3.5, 1000.0), 2.0);
}

}  // namespace
}  // namespace idiophone::advice

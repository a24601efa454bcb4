#include "idiophone/air/waves/wave_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "idiophone/air/waves/surface_sources.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::waves {
namespace {

constexpr double courant = 0.55;
constexpr LossyAir very_lossy = {.viscosity = 0.01, .diffusivity = 0.01};

Grid grid_of(std::array<int, 3> cells, int layer) {
  return {.corner = Vector3(-0.163, -0.141, -0.152), .cell = 0.01, .cells = cells, .layer = layer};
}

/// A sphere in a grid.
struct Setting {
  const char* name;
  Grid grid;
  double radius;  // m
  std::optional<LossyAir> lossy;
};

void PrintTo(const Setting& setting, std::ostream* out) {
  *out << setting.name;
}

/// A sphere that pulsates in one pulse, on any division of its grid.
class Pulsating {
 public:
  Pulsating(const Setting& setting, int ranks, MPI_Comm communicator)
      : field_(Division(setting.grid, ranks), courant, communicator, setting.lossy),
        solid_(radiation::icosphere(setting.radius, 4)) {
    set(Vector3::Zero());
  }
  void set(const Vector3& shift) {
    positions_.clear();
    for (const Vector3& vertex : solid_.vertices) {
      const Vector3 place = vertex + shift;
      positions_.insert(positions_.end(), place.begin(), place.end());
    }
    const Obstruction obstruction{solid_.triangles, positions_};
    CutCells cells(field_.subdomain(), obstruction, courant, field_.is_lossy());
    sources_ = SurfaceSources(field_.subdomain(), obstruction, solid_.triangles.size(), cells, courant);
    node_sources_.resize(cells.nodes().size());
    field_.set_surfaces(std::move(cells));
  }
  void advance(int steps) {
    for (int i = 0; i < steps; ++i, ++step_) {
      const double x = (step_ - 20.0) / 6.0;
      changes_.assign(solid_.triangles.size(), static_cast<float>(-x * std::exp(-0.5 * x * x)));
      sources_.add(changes_, node_sources_);
      field_.step(node_sources_);
    }
  }
  WaveField& field() { return field_; }

 private:
  WaveField field_;
  radiation::Solid solid_;
  std::vector<float> positions_, changes_, node_sources_;
  SurfaceSources sources_;
  int step_ = 0;
};

void expect_same(const WaveField& part, const WaveField& whole) {
  for_each_cell(part.subdomain().cells(), [&](const std::array<int, 3>& cell) {
    ASSERT_EQ(part.pressure(part.subdomain().number(cell)), whole.pressure(whole.subdomain().number(cell)))
        << cell[0] << ' ' << cell[1] << ' ' << cell[2];
  });
}

/// On eight ranks, a long grid is divided along all axes, and the sphere with it.
Setting in_long_grid() {
  const Grid grid{.corner = Vector3(-0.943, -0.071, -0.062), .cell = 0.01, .cells = {176, 15, 13}, .layer = 3};
  return {"long", grid, 0.03, very_lossy};
}

Setting in_odd_grid() {
  return {"odd", grid_of({32, 27, 31}, 6), 0.06, std::nullopt};
}

Setting with_losses() {
  return {"lossy", in_odd_grid().grid, 0.06, very_lossy};
}

Setting on_floor() {
  Setting setting = in_odd_grid();
  setting.name = "floor";
  setting.grid.rigid_below = true;
  return setting;
}

ON_RANKS(1, 3, 8);

class DividedWaveField : public testing::TestWithParam<Setting> {};
INSTANTIATE_TEST_SUITE_P(, DividedWaveField, testing::Values(in_odd_grid(), with_losses(), in_long_grid(), on_floor()));

TEST_P(DividedWaveField, HasTheSameBitsOnAnyRanksWhateverMoves) {
  Pulsating whole(GetParam(), 1, MPI_COMM_SELF);
  Pulsating part(GetParam(), support::ranks(), MPI_COMM_WORLD);
  for (const double shift : {0.0, 0.0031, 0.0087, -0.02}) {
    for (Pulsating* one : {&whole, &part}) {
      one->set(Vector3(shift, -shift, shift));
      one->advance(30);
    }
    expect_same(part.field(), whole.field());
  }
  EXPECT_NE(part.field().pressure(part.field().subdomain().number(part.field().subdomain().cells().from)), 0.0F);
}

ON_RANKS(1, 3);

TEST_P(DividedWaveField, GoesOnFromAnArchive) {
  Pulsating first(GetParam(), support::ranks(), MPI_COMM_WORLD);
  first.advance(40);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  first.field().archive(archive);
  Pulsating second(GetParam(), support::ranks(), MPI_COMM_WORLD);
  second.advance(40);             // to the same moment of the pulse
  for (int i = 0; i < 10; ++i) {  // all of its state differs
    second.field().step(std::vector<float>(second.field().cut_cells().nodes().size()));
  }
  archive.restore();
  second.field().archive(archive);
  first.advance(40);
  second.advance(40);
  expect_same(second.field(), first.field());
}

/// A point of the open field that a pulse passes.
std::vector<float> heard(const Grid& grid, std::array<int, 3> source, std::array<int, 3> receiver, int steps) {
  WaveField field(Division(grid, 1), courant, MPI_COMM_SELF);
  std::vector<float> sound;
  const Index at = field.subdomain().number(source);
  for (int i = 0; i < steps; ++i) {
    const double x = (i - 40.0) / 10.0;
    field.set_pressure(at, field.pressure(at) + static_cast<float>(-x * std::exp(-0.5 * x * x)));
    field.step({});
    sound.push_back(field.pressure(field.subdomain().number(receiver)));
  }
  return sound;
}

ON_RANKS(1);

TEST(WaveField, ReflectsLittleFromItsLayer) {
  // The same pulse in a grid so large that no reflection comes back in time.
  constexpr int steps = 150, more = 40;
  const auto near = heard(grid_of({48, 48, 48}, 10), {16, 24, 24}, {14, 33, 26}, steps);
  const auto far = heard(grid_of({48 + 2 * more, 48 + 2 * more, 48 + 2 * more}, 10), {16 + more, 24 + more, 24 + more},
                         {14 + more, 33 + more, 26 + more}, steps);
  float loudest = 0.0F, reflected = 0.0F;
  for (int i = 0; i < steps; ++i) {
    loudest = std::max(loudest, std::abs(far[i]));
    reflected = std::max(reflected, std::abs(near[i] - far[i]));
  }
  EXPECT_GT(loudest, 0.0F);
  EXPECT_LT(20.0 * std::log10(reflected / loudest), -50.0);
}

TEST(WaveField, IsMirroredByARigidFloor) {
  Grid half = grid_of({32, 32, 16}, 6);
  half.rigid_below = true;
  const Grid whole = grid_of({32, 32, 32}, 6);
  const auto above = heard(half, {14, 16, 2}, {18, 17, 5}, 80);
  const auto both = heard(whole, {14, 16, 18}, {18, 17, 21}, 80);
  const auto image = heard(whole, {14, 16, 13}, {18, 17, 21}, 80);
  for (std::size_t i = 0; i < above.size(); ++i) {
    ASSERT_NEAR(above[i], both[i] + image[i], 1e-5);
  }
}

}  // namespace
}  // namespace idiophone::waves

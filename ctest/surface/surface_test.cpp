#include "idiophone/surface/surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <numeric>

#include "idiophone/surface/emitter.hpp"
#include "memory_archive.hpp"

namespace idiophone::surface {
namespace {

constexpr double pi = std::numbers::pi;

/// Where every vertex is displaced to at a time in s.
using Motion = std::function<Vector3(const Vector3& reference, double time)>;

/// A right triangle of 0.5 cm2 in the plane z = 0, normal +z.
const std::vector<Vector3> corners = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0}};

/// Drives a surface and keeps what the first triangle emits; emitted[i] belongs to audio sample i.
class Driven {
 public:
  Driven(Motion motion, const Sampling& sampling, std::vector<Vector3> reference = corners,
         const std::vector<std::array<Index, 3>>& triangles = {{0, 1, 2}}, double dc_loss = 0.0)
      : reference_(std::move(reference)),
        motion_(std::move(motion)),
        sampling_(sampling),
        surface_(triangles, reference_, sampling),
        emitter_(triangles, dc_loss) {
    displace(0.0);
    emitter_.start(surface_.start());
  }

  void advance(int samples) {
    for (int sample = 0; sample < samples; ++sample) {
      for (int read = 0; read < sampling_.reads_per_sample(); ++read) {
        ++reads_;
        displace(static_cast<double>(reads_) / (sampling_.rate * static_cast<double>(sampling_.reads_per_sample())));
        surface_.read();
      }
      surface_.take(low_passed_);
      emitter_.emit(low_passed_, emission);
      emissions.push_back(emission);
    }
  }

  /// Emission of an audio sample.
  [[nodiscard]] const Emission& at(int sample) const { return emissions.at(sample + sampling_.latency() - 1); }

  Surface& surface() { return surface_; }
  Emitter& emitter() { return emitter_; }
  [[nodiscard]] double time(int sample) const { return static_cast<double>(sample) / sampling_.rate; }

  Emission emission;
  std::vector<Emission> emissions;

 private:
  void displace(double time) {
    for (std::size_t vertex = 0; vertex < reference_.size(); ++vertex) {
      Vector3::Map(&surface_.displacements()[3 * vertex]) = motion_(reference_[vertex], time);
    }
  }

  std::vector<Vector3> reference_;
  Motion motion_;
  Sampling sampling_;
  Surface surface_;
  Emitter emitter_;
  SurfaceMotion low_passed_;
  std::int64_t reads_ = 0;
};

/// Amplitude and phase of a sine in what was sampled, as c of Re(c exp(i w t)), by least squares.
std::complex<double> fit(const std::function<double(int)>& value, double frequency, int rate, int first, int count) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (int sample = first; sample < first + count; ++sample) {
    const double angle = 2.0 * pi * frequency * sample / rate;
    const Eigen::Vector2d basis(std::cos(angle), -std::sin(angle));
    normal += basis * basis.transpose();
    right += basis * value(sample);
  }
  normal.diagonal().array() += 1e-9;  // at half the rate the sine is zero in every sample
  const Eigen::Vector2d solution = normal.inverse() * right;
  return {solution[0], solution[1]};
}

/// Response of the pressure to a triangle that swings along its normal: 1 is an exact copy.
std::complex<double> pressure_response(double frequency, const Sampling& sampling, double dc_loss = 0.0) {
  const double amplitude = 1e-6;
  Driven driven(
      [&](const Vector3&, double t) -> Vector3 {
        return {0, 0, amplitude / (2 * pi * frequency) * std::sin(2 * pi * frequency * t)};
      },
      sampling, corners, {{0, 1, 2}}, dc_loss);
  driven.advance(900 + sampling.latency());
  return fit([&](int i) { return driven.at(i).pressure[0] / (sampling.impedance * amplitude); }, frequency,
             sampling.rate, 400, 480);
}

double decibels(std::complex<double> response) {
  return 20.0 * std::log10(std::abs(response));
}

/// Eqs. 6-8 summed directly: the response of the normalised kernel with taps at every step.
double kernel_response(double frequency, double max_frequency, double step, int w) {
  double sum = 0.0, total = 0.0;
  for (int i = -w; i <= w; ++i) {
    const double t = i * step;
    const double sinc = i == 0 ? 2.0 * max_frequency : std::sin(2.0 * pi * max_frequency * t) / (pi * t);
    const double tap = sinc * (0.5 + 0.5 * std::cos(pi * i / w));
    sum += tap * std::cos(2.0 * pi * frequency * t);
    total += tap;
  }
  return sum / total;
}

const Sampling paper{.rate = 44100, .steps_per_sample = 24, .steps_per_read = 4};

TEST(LowPass, IsMinusSixDecibelsAtTheCutoff) {
  EXPECT_NEAR(decibels(pressure_response(22050.0, paper)), -6.02, 0.03);
}

TEST(LowPass, IsMinusFortyFourDecibelsAt29kHz) {
  EXPECT_NEAR(decibels(pressure_response(29000.0, paper)), -44.0, 1.0);
}

TEST(LowPass, IsFlatBelowWithoutDelay) {
  for (const double frequency : {20.0, 1000.0, 5000.0, 10000.0, 13000.0}) {
    const auto response = pressure_response(frequency, paper);
    EXPECT_NEAR(decibels(response), 0.0, 0.02) << frequency;
    EXPECT_NEAR(std::arg(response), 0.0, 1e-4) << frequency;
  }
}

TEST(LowPass, IsThePapersKernelWhateverTheReads) {
  for (const int steps_per_read : {1, 2, 4}) {
    Sampling sampling = paper;
    sampling.steps_per_read = steps_per_read;
    const double step = 1.0 / (44100.0 * 24.0);
    EXPECT_EQ(sampling.half_width(), 144);
    for (const double frequency : {3000.0, 18000.0, 20000.0, 22050.0, 24000.0}) {
      EXPECT_NEAR(pressure_response(frequency, sampling).real(), kernel_response(frequency, 22050.0, step, 144), 1e-3)
          << frequency << " Hz, reads of " << steps_per_read << " steps";
    }
  }
}

TEST(LowPass, RestoresWhatTheMeanOverAReadLoses) {
  // By itself the mean over a sixth of an audio sample loses 0.08 dB of 20 kHz.
  const double lost = std::sin(pi * 20000.0 / (6 * 44100.0)) / (pi * 20000.0 / (6 * 44100.0));
  const double expected = kernel_response(20000.0, 22050.0, 1.0 / (44100.0 * 24.0), 144);
  EXPECT_NEAR(20.0 * std::log10(lost), -0.08, 0.01);
  EXPECT_NEAR(pressure_response(20000.0, paper).real() / expected, 1.0, 0.001);
}

TEST(LowPass, HandlesManyReadsAndUnevenSteps) {
  const Sampling sampling{.rate = 44100, .steps_per_sample = 37, .steps_per_read = 1};
  EXPECT_NEAR(pressure_response(18000.0, sampling).real(),
              kernel_response(18000.0, 22050.0, 1.0 / (44100.0 * 37.0), 222), 1e-3);
}

TEST(LowPass, HandlesALowerCutoff) {
  const Sampling sampling{
      .rate = 48000, .steps_per_sample = 20, .steps_per_read = 4, .max_frequency = 7000.0, .kernel_wavelengths = 4.5};
  EXPECT_EQ(sampling.latency(), 31);
  EXPECT_NEAR(decibels(pressure_response(7000.0, sampling)), -6.02, 0.05);
  EXPECT_NEAR(decibels(pressure_response(3000.0, sampling)), 0.0, 0.02);
}

TEST(LowPass, FiltersPositionsLikePressuresAtTheSampleItself) {
  for (const double frequency : {100.0, 10000.0, 22050.0, 29000.0}) {
    const double amplitude = 1e-4;
    Driven driven(
        [&](const Vector3&, double t) -> Vector3 {
          return {0, amplitude * std::cos(2 * pi * frequency * t), 0};
        },
        paper);
    driven.advance(900);
    const auto response =
        fit([&](int i) { return (driven.at(i).centre[1][0] - 0.01 / 3.0) / amplitude; }, frequency, 44100, 400, 480);
    EXPECT_NEAR(response.real(), kernel_response(frequency, 22050.0, 1.0 / (44100.0 * 24.0), 144), 1e-3) << frequency;
    EXPECT_NEAR(response.imag(), 0.0, 1e-6);
  }
}

TEST(DcBlock, ThePapersLossIsMinusThreeDecibelsAt700Hz) {
  for (const double frequency : {70.0, 700.0, 5000.0}) {
    // Eq. 9 is H(z) = (1 - 1/z)/(1 - (1 - alpha)/z).
    const auto delay = std::exp(std::complex(0.0, -2.0 * pi * frequency / 44100.0));
    const auto expected = (1.0 - delay) / (1.0 - 0.9 * delay);
    EXPECT_LT(std::abs(pressure_response(frequency, paper, 0.1) - expected), 2e-3) << frequency;
  }
  EXPECT_NEAR(decibels(pressure_response(702.0, paper, 0.1)), -3.0, 0.5);
}

TEST(DcBlock, RemovesTheConstantPressureOfASteadyFlight) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {0, 0, 3.0 * t}; }, paper, corners, {{0, 1, 2}}, 0.1);
  driven.advance(300);
  EXPECT_NEAR(driven.at(290).pressure[0], 0.0, 1e-9);
  EXPECT_GT(driven.at(0).pressure[0], 100.0);
}

TEST(DcBlock, HearsNothingOfASteadyFlightThatHasAlwaysBeen) {
  const Vector3 velocity(1.0, 2.0, 3.0);
  Surface surface({{0, 1, 2}}, corners, paper);
  Emitter emitter({{0, 1, 2}}, 0.1);
  std::ranges::fill(surface.displacements(), 0.0);
  std::vector<double> velocities;
  for (int vertex = 0; vertex < 3; ++vertex) {
    velocities.insert(velocities.end(), velocity.begin(), velocity.end());
  }
  emitter.start(surface.start(velocities));
  SurfaceMotion motion;
  Emission emission;
  for (int read = 1; read <= 20 * paper.reads_per_sample(); ++read) {
    const Vector3 place = velocity * read / (paper.rate * static_cast<double>(paper.reads_per_sample()));
    for (std::size_t i = 0; i < 9; ++i) {
      surface.displacements()[i] = place[i % 3];
    }
    surface.read();
    if (read % paper.reads_per_sample() == 0) {
      surface.take(motion);
      emitter.emit(motion, emission);
      EXPECT_NEAR(emission.pressure[0], 0.0, 1e-9);
    }
  }
}

TEST(Surface, TranslatingTriangleHasPressureAreaNormalAndCentre) {
  const Vector3 velocity(1.0, -2.0, 3.0);
  Driven driven([&](const Vector3&, double t) -> Vector3 { return velocity * t; }, paper);
  driven.advance(120);
  const Emission& emission = driven.at(100);
  EXPECT_NEAR(emission.pressure[0], 415.03 * 3.0, 1e-8);  // eqs. 2 and 5
  EXPECT_NEAR(emission.area[0], 0.5e-4, 1e-16);           // eq. 3
  const Vector3 centre = velocity * driven.time(100) + Vector3(0.01, 0.01, 0.0) / 3.0;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(emission.normal[axis][0], axis == 2 ? 1.0 : 0.0, 1e-13);  // eq. 4
    EXPECT_NEAR(emission.centre[axis][0], centre[axis], 1e-14);
  }
}

TEST(Surface, RotatingTriangleTurnsItsNormalAndFeelsItsCentresVelocity) {
  const double rate = 2.0 * pi * 50.0;  // about the y axis through the origin
  const auto turn = [&](double t) { return Eigen::AngleAxisd(rate * t, Vector3::UnitY()).toRotationMatrix(); };
  Driven driven([&](const Vector3& X, double t) -> Vector3 { return turn(t) * X - X; }, paper);
  driven.advance(400);
  for (const int sample : {50, 200, 350}) {
    const Vector3 normal = turn(driven.time(sample)) * Vector3::UnitZ();
    const Emission& emission = driven.at(sample);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(emission.normal[axis][0], normal[axis], 1e-5);
    }
    EXPECT_NEAR(emission.area[0], 0.5e-4, 1e-9);
    // The centre swings about the axis at x = 1/300 m: into the plane's back.
    EXPECT_NEAR(emission.pressure[0], -415.03 * rate * 0.01 / 3.0, 1e-4);
  }
}

TEST(Surface, RestsAtItsFirstDisplacement) {
  Driven driven([](const Vector3&, double) -> Vector3 { return {0.5, -0.25, 2.0}; }, paper);
  driven.advance(40);
  for (const auto& emission : driven.emissions) {
    EXPECT_EQ(emission.pressure[0], 0.0);
    EXPECT_NEAR(emission.centre[2][0], 2.0, 1e-14);
  }
}

TEST(Surface, PadsWithTrianglesThatAreNotThere) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {t, t, t}; }, paper);
  driven.advance(20);
  ASSERT_EQ(driven.emission.pressure.size(), 8U);
  for (std::size_t padding = 1; padding < 8; ++padding) {
    EXPECT_EQ(driven.emission.pressure[padding], 0.0);
    EXPECT_EQ(driven.emission.area[padding], 0.0);
    EXPECT_EQ(driven.emission.normal[2][padding], 0.0);
    EXPECT_TRUE(std::isfinite(driven.emission.centre[0][padding]));
  }
}

/// Ripples in every direction, so that no two triangles emit alike.
Vector3 ripple(const Vector3& X, double t) {
  return 1e-4 * Vector3(std::sin(900.0 * X.x() + 30000.0 * t), std::cos(700.0 * X.y() - 20000.0 * t),
                        std::sin(800.0 * (X.x() + X.y()) + 50000.0 * t));
}

/// A strip of n triangles.
struct Strip {
  explicit Strip(Index n) {
    for (Index i = 0; i < n + 2; ++i) {
      reference.emplace_back(0.005 * i, 0.01 * (i % 2), 0.002 * (i % 3));
    }
    for (Index i = 0; i < n; ++i) {
      triangles.push_back(i % 2 == 0 ? std::array{i, i + 1, i + 2} : std::array{i + 1, i, i + 2});
    }
  }
  std::vector<Vector3> reference;
  std::vector<std::array<Index, 3>> triangles;
};

void expect_same_bits(const Emission& a, std::size_t i, const Emission& b, std::size_t j) {
  EXPECT_EQ(a.pressure[i], b.pressure[j]);
  EXPECT_EQ(a.area[i], b.area[j]);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(a.normal[axis][i], b.normal[axis][j]);
    EXPECT_EQ(a.centre[axis][i], b.centre[axis][j]);
  }
}

TEST(Surface, ATriangleGivesTheSameBitsAtAnyPlace) {
  constexpr double dc_loss = 0.01;
  const Strip strip(21);
  Driven whole(ripple, paper, strip.reference, strip.triangles, dc_loss);
  whole.advance(30);
  for (std::size_t number = 0; number < strip.triangles.size(); ++number) {
    std::vector<Vector3> reference;
    for (const Index vertex : strip.triangles[number]) {
      reference.push_back(strip.reference[vertex]);
    }
    Driven alone(ripple, paper, reference, {{0, 1, 2}}, dc_loss);
    alone.advance(30);
    expect_same_bits(whole.emission, number, alone.emission, 0);
    EXPECT_NE(alone.emission.pressure[0], 0.0);
  }
}

TEST(Surface, GoesOnFromASavedStateToTheBitAlsoInAnotherOrder) {
  constexpr double dc_loss = 0.05;
  const Strip strip(13);
  Driven straight(ripple, paper, strip.reference, strip.triangles, dc_loss);
  straight.advance(29);
  const auto rows = [](std::vector<Index> numbers) {
    const std::size_t count = numbers.size();
    return parallel::Rows(numbers, static_cast<std::int64_t>(count), MPI_COMM_SELF);
  };
  std::vector<Index> numbers(13), vertex_numbers(15);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::iota(vertex_numbers.begin(), vertex_numbers.end(), 0);
  test_support::MemoryArchive archive(MPI_COMM_SELF);
  straight.surface().archive(archive, rows(numbers), rows(vertex_numbers));
  straight.emitter().archive(archive, rows(numbers));
  straight.advance(1);

  // Resumed with triangles in reverse, as another partition might have them.
  archive.restore();
  auto triangles = strip.triangles;
  std::ranges::reverse(triangles);
  std::ranges::reverse(numbers);
  Surface resumed(triangles, strip.reference, paper);
  resumed.archive(archive, rows(numbers), rows(vertex_numbers));
  Emitter emitter(triangles, dc_loss);
  emitter.archive(archive, rows(numbers));
  for (int read = 1; read <= 6; ++read) {
    for (std::size_t vertex = 0; vertex < strip.reference.size(); ++vertex) {
      Vector3::Map(&resumed.displacements()[3 * vertex]) =
          ripple(strip.reference[vertex], (29.0 * 6.0 + read) / (44100.0 * 6.0));
    }
    resumed.read();
  }
  SurfaceMotion motion;
  resumed.take(motion);
  Emission emission;
  emitter.emit(motion, emission);
  for (std::size_t number = 0; number < 13; ++number) {
    expect_same_bits(emission, 12 - number, straight.emission, number);
  }
}

TEST(Surface, LetsNotANumberThrough) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {0, 0, t > 1e-4 ? std::nan("") : 0.0}; }, paper);
  driven.advance(20);
  EXPECT_TRUE(std::isnan(driven.emission.pressure[0]));
}

TEST(Surface, MayBeEmpty) {
  Surface surface({}, {}, paper);
  surface.start();
  for (int read = 0; read < 6; ++read) {
    surface.read();
  }
  SurfaceMotion motion;
  surface.take(motion);
  Emission emission;
  Emitter({}, 0.0).emit(motion, emission);
  EXPECT_TRUE(emission.pressure.empty());
}

TEST(Surface, SaysWhatIsWrongWithItsArguments) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  const auto make = [](const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& reference,
                       const Sampling& sampling) { return [=] { Surface(triangles, reference, sampling); }; };
  EXPECT_THAT(make({{0, 1, 3}}, corners, paper), ThrowsMessage<std::invalid_argument>(HasSubstr("vertex 3")));
  EXPECT_THAT(make({{0, 1, 2}, {0, 1, 1}}, corners, paper),
              ThrowsMessage<std::invalid_argument>(HasSubstr("triangle 1")));
  EXPECT_THAT(make({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, paper),
              ThrowsMessage<std::invalid_argument>(HasSubstr("not finite")));
  Sampling sampling = paper;
  sampling.steps_per_read = 5;
  EXPECT_THAT(make({{0, 1, 2}}, corners, sampling), ThrowsMessage<std::invalid_argument>(HasSubstr("divisor")));
  sampling = paper;
  sampling.max_frequency = 30000.0;
  EXPECT_THAT(make({{0, 1, 2}}, corners, sampling), ThrowsMessage<std::invalid_argument>(HasSubstr("max_frequency")));
  EXPECT_THAT([] { Emitter({{0, 1, 2}}, 1.0); }, ThrowsMessage<std::invalid_argument>(HasSubstr("dc_loss")));
}

TEST(Surface, RefusesCallsOutOfTurn) {
  Surface surface({{0, 1, 2}}, corners, paper);
  surface.start();
  SurfaceMotion motion;
  EXPECT_THROW(surface.take(motion), std::logic_error);
  surface.read();
  const parallel::Rows triangle(std::vector<Index>{0}, 1, MPI_COMM_SELF);
  const parallel::Rows vertices(std::vector<Index>{0, 1, 2}, 3, MPI_COMM_SELF);
  test_support::MemoryArchive archive(MPI_COMM_SELF);
  EXPECT_THROW(surface.archive(archive, triangle, vertices), std::logic_error);
  for (int read = 1; read < 6; ++read) {
    surface.read();
  }
  EXPECT_THROW(surface.read(), std::logic_error);
  surface.take(motion);
  EXPECT_NO_THROW(surface.archive(archive, triangle, vertices));
}

}  // namespace
}  // namespace idiophone::surface

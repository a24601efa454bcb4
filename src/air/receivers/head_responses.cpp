#include "idiophone/air/receivers/head_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "sofa_file.hpp"

namespace idiophone::receivers {

namespace {

constexpr std::size_t ears = 2;  // left, right

std::string explain(int error) {
  switch (error) {
    case MYSOFA_READ_ERROR:
      return "it can't be read";
    case MYSOFA_INVALID_FORMAT:
    case MYSOFA_UNSUPPORTED_FORMAT:
      return "it is not a SOFA file, or not of a kind that libmysofa can read";
    default:
      return fmt::format("it does not follow the convention SimpleFreeFieldHRIR (libmysofa error {})", error);
  }
}

/// |sum_k taps[k] exp(-i w k)|^2
double power(const std::vector<double>& taps, double angular_frequency) {
  std::complex<double> sum;
  for (std::size_t k = 0; k < taps.size(); ++k) {
    sum += taps[k] * std::polar(1.0, -angular_frequency * static_cast<double>(k));
  }
  return std::norm(sum);
}

}  // namespace

HeadResponses::HeadResponses(const std::filesystem::path& file, int rate) : rate_(rate), file_(nullptr, mysofa_close) {
  const SofaFile opened = open_sofa_file(file, rate);
  file_.reset(opened.contents);
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("{} has no head-related responses: {}", file.string(), why));
  };
  if (!file_) {
    refuse(explain(opened.error));
  }
  taps_ = opened.taps;
  const MYSOFA_HRTF& measured = *file_->hrtf;
  if (measured.R != ears) {
    refuse(fmt::format("it has {} ears", measured.R));
  }
  const auto* delays = measured.DataDelay.values;
  if (std::any_of(delays, delays + measured.DataDelay.elements, [](float delay) { return delay != 0.0F; })) {
    refuse("it stores delays apart from the responses; include them in the responses");
  }
  const double front = power_of_front();
  if (!(front > 0.0) || !std::isfinite(front)) {
    refuse("the response of the front is zero");
  }
  scale_ = 1.0 / std::sqrt(front);
}

double HeadResponses::power_of_front() const {
  constexpr double lowest = 200.0, step = 10.0;  // Hz
  constexpr int steps = 40;
  const Responses front = responses(nearest(Vector3::UnitX()));
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    for (const auto& ear : front) {
      sum += power(ear, 2.0 * std::numbers::pi * (lowest + i * step) / rate_);
    }
  }
  return sum / static_cast<double>((steps + 1) * ears);
}

std::size_t HeadResponses::count() const {
  return file_->hrtf->M;
}

Vector3 HeadResponses::direction(std::int64_t number) const {
  const float* position = &file_->hrtf->SourcePosition.values[3 * number];
  return Vector3(position[0], position[1], position[2]).normalized();
}

std::int64_t HeadResponses::nearest(const Vector3& direction) const {
  // At the largest measured distance, so that the nearest measurement is nearest in direction.
  const Vector3 unit = direction.isZero(0.0) ? Vector3::UnitX() : Vector3(direction.stableNormalized());
  const Eigen::Vector3f place = (unit * file_->lookup->radius_max).cast<float>();
  std::array<float, 3> coordinate = {place[0], place[1], place[2]};
  return mysofa_lookup(file_->lookup, coordinate.data());
}

Responses HeadResponses::responses(std::int64_t number) const {
  const float* values = &file_->hrtf->DataIR.values[number * ears * taps_];
  Responses both;
  for (std::size_t ear = 0; ear < ears; ++ear) {
    auto& taps = both.emplace_back(values + ear * taps_, values + (ear + 1) * taps_);
    for (double& tap : taps) {
      tap *= scale_;
    }
  }
  return both;
}

}  // namespace idiophone::receivers

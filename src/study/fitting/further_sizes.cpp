#include "further_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::fitting {

namespace {

struct Size {
  int side = 0;         ///< StrainedBody::direction()
  double factor = 1.0;  ///< of its length

  bool operator==(const Size&) const = default;
};

constexpr Size sizes[] = {{0, 0.25}, {0, 0.5}, {0, 2},    {0, 4},   {1, 0.25}, {1, 0.5},
                          {1, 2},    {1, 4},   {2, 0.25}, {2, 0.5}, {2, 2},    {2, 4}};

/// A specimen of another size.
struct SizedBody {
  Size size;
  StrainedBody body;
  FrequencyModel model;  ///< of its lowest modes
};

/// A body that another length of a side leaves a block, a bar or a plate: one that fills its box. A cylinder fills
/// pi/4.
bool is_compact(const StrainedBody& body) {
  constexpr double least = 0.75;
  return body.volume() >= least * body.extents().prod();
}

std::string refusal_of(const Size& size, const Specimen& specimen, const std::exception& reason) {
  return fmt::format("{:g} times as long along [{:.2f}]: {}", size.factor,
                     fmt::join(specimen.body.direction(size.side), ", "), reason.what());
}

/// @param refused  why there is no such body goes there
/// @return none where what holds the body is no longer on its surface, or its modes can't be found
std::shared_ptr<const SizedBody> sized_body(const Size& size, const Specimen& specimen,
                                            std::vector<std::string>& refused) {
  std::optional<StrainedBody> body;
  try {
    body = specimen.body.stretched(size.side, size.factor);
  } catch (const deck::DeckError& reason) {
    refused.push_back(refusal_of(size, specimen, reason));
    return nullptr;
  }
  try {
    FrequencyModel model = body->lowest(specimen.material, specimen.modes);
    return std::make_shared<const SizedBody>(size, *std::move(body), std::move(model));
  } catch (const std::runtime_error& reason) {  // all that find_modes() throws: the constants must not be lost for it
    refused.push_back(refusal_of(size, specimen, reason));
    return nullptr;
  }
}

/// Half-widths of the intervals that the lines of a body would leave.
/// @param mesh_errors  [multiplets of its model] cents
Eigen::VectorXd widths_of(const SizedBody& sized, const Specimen& specimen, const std::vector<double>& mesh_errors,
                          const Eigen::MatrixXd& slopes) {
  const Evidence evidence =
      imagined_lines(sized.model, specimen.constants, specimen.material, specimen.uncertainty, mesh_errors);
  return half_widths(evidence, specimen.residuals, specimen.expected, slopes);
}

/// For each unknown, the body of the size that leaves the smallest interval, without the errors of the mesh; none where
/// all leave one above its limit. [constants]
std::vector<std::shared_ptr<const SizedBody>> best_sizes(const Specimen& specimen, Eigen::VectorXd limits,
                                                         const std::function<void(int solves)>& watch,
                                                         std::vector<std::string>& refused) {
  const Eigen::MatrixXd of_unknowns = Eigen::MatrixXd::Identity(limits.size(), limits.size());
  std::vector<std::shared_ptr<const SizedBody>> best(specimen.constants.size());
  for (const Size& size : sizes) {
    const std::shared_ptr<const SizedBody> sized = sized_body(size, specimen, refused);
    watch(1);
    if (!sized) {
      continue;
    }
    const std::vector<double> no_errors(sized->model.multiplets().size());
    const Eigen::VectorXd left = widths_of(*sized, specimen, no_errors, of_unknowns);
    for (Eigen::Index k = 0; k < limits.size(); ++k) {
      if (left[k] < limits[k]) {
        limits[k] = left[k];
        best[static_cast<std::size_t>(k)] = sized;
      }
    }
  }
  return best;
}

}  // namespace

FurtherSizes further_sizes(const Specimen& specimen, const Eigen::VectorXd& widths,
                           const std::function<void(int solves)>& watch) {
  constexpr double worthwhile = 0.5;  // of the interval that is known
  const Eigen::VectorXd limits = worthwhile * widths;
  if (limits.isZero(0.0) || !is_compact(specimen.body)) {
    return {};
  }
  FurtherSizes found;
  const std::vector<std::shared_ptr<const SizedBody>> best = best_sizes(specimen, limits, watch, found.refused);
  const Eigen::MatrixXd of_unknowns = Eigen::MatrixXd::Identity(limits.size(), limits.size());
  const Eigen::MatrixXd of_values = value_slopes(specimen.constants, specimen.material);
  for (const Size& size : sizes) {
    const auto place = std::ranges::find_if(best, [&](const auto& body) { return body && body->size == size; });
    if (place == best.end()) {
      continue;
    }
    const SizedBody& sized = **place;
    const std::vector<double> mesh_errors = sized.body.mesh_errors(sized.model);
    watch(0);
    const Eigen::VectorXd left = widths_of(sized, specimen, mesh_errors, of_unknowns);
    const Eigen::VectorXd left_of_values = widths_of(sized, specimen, mesh_errors, of_values);
    for (std::size_t k = 0; k < best.size(); ++k) {
      const auto unknown = static_cast<Eigen::Index>(k);
      if (best[k] == *place && left[unknown] <= limits[unknown]) {
        found.named.push_back({.constant = specimen.constants[k].name,
                               .factor = size.factor,
                               .along = specimen.body.direction(size.side),
                               .extents = sized.body.extents(),
                               .lines = static_cast<int>(mesh_errors.size()),
                               .highest = sized.model.frequencies(specimen.material).tail(1)[0],
                               .half_width = left_of_values[unknown],
                               .is_determined = left[unknown] <= undetermined});
      }
    }
  }
  return found;
}

}  // namespace idiophone::fitting

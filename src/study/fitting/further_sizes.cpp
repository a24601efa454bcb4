#include "further_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

/// What the lines of a specimen would say.
struct SizedEvidence {
  Evidence evidence;
  Vector3 extents;       ///< m
  double highest = 0.0;  ///< of the lines, Hz
};

enum class MeshErrors { left_out, estimated };

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

struct SizedBody {
  StrainedBody body;
  FrequencyModel model;  ///< of its lowest modes
};

/// @param refused  why there is no such body goes there
/// @return none where what holds the body is no longer on its surface, or its modes can't be found
std::optional<SizedBody> sized_body(const Size& size, const Specimen& specimen, std::vector<std::string>& refused) {
  std::optional<StrainedBody> body;
  try {
    body = specimen.body.stretched(size.side, size.factor);
  } catch (const deck::DeckError& reason) {
    refused.push_back(refusal_of(size, specimen, reason));
    return {};
  }
  try {
    FrequencyModel model = body->lowest(specimen.material, specimen.modes);
    return SizedBody{*std::move(body), std::move(model)};
  } catch (const std::runtime_error& reason) {  // all that find_modes() throws: the constants must not be lost for it
    refused.push_back(refusal_of(size, specimen, reason));
    return {};
  }
}

/// @return as sized_body()
std::optional<SizedEvidence> evidence_at(const Size& size, const Specimen& specimen, MeshErrors wanted,
                                         std::vector<std::string>& refused) {
  const std::optional<SizedBody> sized = sized_body(size, specimen, refused);
  if (!sized) {
    return {};
  }
  const auto& [body, model] = *sized;
  const std::vector<double> errors =
      wanted == MeshErrors::estimated ? body.mesh_errors(model) : std::vector<double>(model.multiplets().size());
  return SizedEvidence{imagined_lines(model, specimen.constants, specimen.material, specimen.uncertainty, errors),
                       body.extents(), model.frequencies(specimen.material).tail(1)[0]};
}

Eigen::VectorXd widths_of(const SizedEvidence& sized, const Specimen& specimen, const Eigen::MatrixXd& slopes) {
  return half_widths(sized.evidence, specimen.residuals, specimen.expected, slopes);
}

/// For each unknown, the size that leaves the smallest interval, without the errors of the mesh; none where all leave
/// one above its limit. [constants]
std::vector<std::optional<Size>> best_sizes(const Specimen& specimen, Eigen::VectorXd limits,
                                            const std::function<void()>& watch, std::vector<std::string>& refused) {
  const Eigen::MatrixXd of_unknowns = Eigen::MatrixXd::Identity(limits.size(), limits.size());
  std::vector<std::optional<Size>> best(specimen.constants.size());
  for (const Size& size : sizes) {
    const std::optional<SizedEvidence> sized = evidence_at(size, specimen, MeshErrors::left_out, refused);
    watch();
    const Eigen::VectorXd left = sized ? widths_of(*sized, specimen, of_unknowns) : limits;
    for (Eigen::Index k = 0; k < limits.size(); ++k) {
      if (left[k] < limits[k]) {
        limits[k] = left[k];
        best[static_cast<std::size_t>(k)] = size;
      }
    }
  }
  return best;
}

}  // namespace

FurtherSizes further_sizes(const Specimen& specimen, const Eigen::VectorXd& widths,
                           const std::function<void()>& watch) {
  constexpr double worthwhile = 0.5;  // of the interval that is known
  const Eigen::VectorXd limits = worthwhile * widths;
  if (limits.isZero(0.0) || !is_compact(specimen.body)) {
    return {};
  }
  FurtherSizes found;
  const std::vector<std::optional<Size>> best = best_sizes(specimen, limits, watch, found.refused);
  const Eigen::MatrixXd of_unknowns = Eigen::MatrixXd::Identity(limits.size(), limits.size());
  const Eigen::MatrixXd of_values = value_slopes(specimen.constants, specimen.material);
  for (const Size& size : sizes) {
    if (std::ranges::find(best, size) == best.end()) {
      continue;
    }
    const std::optional<SizedEvidence> sized = evidence_at(size, specimen, MeshErrors::estimated, found.refused);
    watch();
    if (!sized) {
      continue;
    }
    const Eigen::VectorXd left = widths_of(*sized, specimen, of_unknowns);
    const Eigen::VectorXd left_of_values = widths_of(*sized, specimen, of_values);
    for (std::size_t k = 0; k < best.size(); ++k) {
      const auto place = static_cast<Eigen::Index>(k);
      if (best[k] == size && left[place] <= limits[place]) {
        found.named.push_back({.constant = specimen.constants[k].name,
                               .factor = size.factor,
                               .along = specimen.body.direction(size.side),
                               .extents = sized->extents,
                               .lines = static_cast<int>(sized->evidence.slopes.rows()),
                               .highest = sized->highest,
                               .half_width = left_of_values[place],
                               .is_determined = left[place] <= undetermined});
      }
    }
  }
  return found;
}

}  // namespace idiophone::fitting

#pragma once
// Fits the elastic constants of a body to measured lines.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "assignment.hpp"
#include "elastic_constants.hpp"
#include "frequency_model.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {

/// A fit in progress.
class MaterialFit {
 public:
  /// @param solids  one body
  MaterialFit(const scene::Solids& solids, const Measurements& measured, const IdentificationOptions& options);

  /// Fits until all constants left are determined.
  void run(Identification& result);

  [[nodiscard]] const scene::Material& material() const { return material_; }
  [[nodiscard]] const FrequencyModel& model() const { return *model_; }
  [[nodiscard]] std::size_t fitted_lines() const { return lines_.size(); }

 private:
  void solve(double margin);
  void align();
  void fit();
  void adjust(double tolerance);
  [[nodiscard]] double adjust_from_here(double tolerance);
  void fit_pairs(const LinePairs& pairs);
  [[nodiscard]] std::optional<Eigen::VectorXd> residuals(const LinePairs& pairs, const Eigen::VectorXd& point) const;
  [[nodiscard]] Eigen::MatrixXd jacobian(const LinePairs& pairs, const Eigen::VectorXd& point) const;
  void note(const Eigen::VectorXd& widths, Identification& result);
  void hold(std::ptrdiff_t place, Identification& result);

  const IdentificationOptions& options_;
  StrainedBody body_;
  scene::Material start_, material_;
  std::vector<Line> lines_;  ///< to be fitted
  double highest_ = 0.0;     ///< of all lines, Hz
  ElasticConstants constants_;
  std::optional<FrequencyModel> model_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd jacobian_;
  int solves_ = 0;
};

}  // namespace idiophone::fitting

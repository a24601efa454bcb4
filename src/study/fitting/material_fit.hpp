#pragma once
// Fits the elastic constants of a body to measured lines.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "confidence.hpp"
#include "elastic_constants.hpp"
#include "frequency_model.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "matched_fit.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {

inline constexpr double roughly = 3e-3;           // change of an unknown, before the constants are chosen
inline constexpr double nearby = 0.03;            // for which solved modes still span those that are wanted
inline constexpr std::size_t first_lines = 20;    // of a fit, the lowest; twice as many with each solve
inline constexpr double first_tolerance = 200.0;  // cents; halved with each solve, down to the wanted one

/// The largest change of an unknown between two materials.
[[nodiscard]] double distance(const ElasticConstants& constants, const TurnedMaterial& a, const TurnedMaterial& b);

/// The search was told to stop.
struct Stopped {};

/// A fit in progress.
class MaterialFit {
 public:
  /// @param body  of the material to begin with
  MaterialFit(StrainedBody body, const Measurements& measured, const IdentificationOptions& options);

  /// Fits, from few constants to all that the lines determine.
  void run(Identification& result);

  [[nodiscard]] const TurnedMaterial& material() const { return material_; }
  [[nodiscard]] const FrequencyModel& model() const { return *model_; }
  [[nodiscard]] std::size_t fitted_lines() const { return lines_.size(); }
  /// Cents by which the mesh may make the mode of a fitted line wrong; 0 for a line without a mode.
  [[nodiscard]] double mesh_error(std::size_t line) const { return mesh_errors_[line]; }

 private:
  struct Held {
    TurnedMaterial material;
    double squares;  ///< of the lines' distances over their uncertainties; infinite where there is no such material
  };

  /// Where a search may go on.
  struct Start {
    TurnedMaterial material;
    Expectation expected;
    double cost = 0.0;  ///< of the assignment of the lowest lines to its modes
  };

  /// Modes whose lines may be measured next.
  struct FurtherModes {
    std::vector<Multiplet> multiplets;
    Eigen::VectorXd frequencies;    ///< [multiplets] Hz
    Evidence lines;                 ///< that they would be
    std::vector<bool> is_measured;  ///< [multiplets]
  };

  void search();
  [[nodiscard]] std::vector<Start> begin(const std::vector<TurnedMaterial>& materials);
  [[nodiscard]] std::vector<Start> other_starts(const std::vector<Start>& starts);
  [[nodiscard]] std::vector<TurnedMaterial> other_materials() const;
  void fit_from(const Start& start);
  [[nodiscard]] double freedom() const;
  [[nodiscard]] double chi_squared() const;
  [[nodiscard]] bool is_believable() const;
  [[nodiscard]] double cost() const;
  void take(MaterialFit other);
  [[nodiscard]] int starting_turns() const;
  [[nodiscard]] std::vector<TurnedMaterial> turned_starts() const;
  [[nodiscard]] std::vector<Start> find_starts(const std::vector<TurnedMaterial>& materials,
                                               const std::vector<Line>& lowest, StrainedBody& body);
  void solve_lowest(StrainedBody& body, const TurnedMaterial& material, std::size_t lines);
  void approach(const std::vector<Line>& lowest, StrainedBody& body, Start& start, double least);
  void keep(const Start& start);
  void refine();
  void choose();
  void weigh();
  void settle();
  void look_for_equivalents(Identification& result);
  [[nodiscard]] std::optional<TurnedMaterial> with_turns(const Vector3& turns) const;
  [[nodiscard]] bool are_within_intervals(const TurnedMaterial& a, const TurnedMaterial& b) const;
  [[nodiscard]] bool fits_as_well(const TurnedMaterial& material);
  void look_further(Identification& result);
  void renew_model(double trusted);
  void note_solves(int solves);
  void heed_watch() const;
  double adopt(const MatchedFit& fit);
  [[nodiscard]] FitProblem problem() const { return {lines_, *model_, constants_}; }
  [[nodiscard]] std::vector<double> likely_shifts(const std::vector<Line>& lines, const TurnedMaterial& start) const;
  [[nodiscard]] bool has_turns() const;
  [[nodiscard]] double model_up_to() const;
  [[nodiscard]] bool has_no_effect(const ElasticConstant& constant) const;
  [[nodiscard]] Expectation expectation_of(const TurnedMaterial& material) const;
  [[nodiscard]] Held fit_chosen(const std::vector<bool>& chosen) const;
  [[nodiscard]] bool add_needed(std::vector<bool>& chosen) const;
  [[nodiscard]] Evidence evidence() const;
  [[nodiscard]] Evidence over_turns(Evidence evidence) const;
  [[nodiscard]] Eigen::VectorXd secant(Eigen::Index turn, double change) const;
  [[nodiscard]] Eigen::VectorXd held_constants() const;
  [[nodiscard]] FurtherModes further_modes();
  [[nodiscard]] double usual_uncertainty() const;
  [[nodiscard]] std::pair<Eigen::Index, double> narrowest(const FurtherModes& modes, const Evidence& known,
                                                          const ResidualSpread& residuals,
                                                          const Eigen::RowVectorXd& combination) const;
  [[nodiscard]] FurtherLine further_line(const FurtherModes& modes, Eigen::Index mode, Eigen::Index constant,
                                         double half_width) const;
  [[nodiscard]] Eigen::VectorXd widths_by_lines(const Eigen::MatrixXd& slopes) const;
  [[nodiscard]] bool is_settled() const;
  [[nodiscard]] bool has_stayed(const TurnedMaterial& before, double within) const;
  void tell(Identification& result) const;

  IdentificationOptions options_;
  StrainedBody body_;
  TurnedMaterial start_, material_;
  std::vector<Line> measured_;
  std::vector<Line> lines_;  ///< to be fitted
  double highest_ = 0.0;     ///< of all lines, Hz
  ElasticConstants constants_;
  std::vector<Ties> stages_;
  Expectation expected_;
  std::optional<FrequencyModel> model_;
  TurnedMaterial modelled_;               ///< that the model is of
  std::optional<TurnedMaterial> solved_;  ///< with which all modes up to the highest line were solved last
  LinePairs pairs_;
  std::vector<double> mesh_errors_;  ///< [lines] cents
  std::vector<bool> chosen_;         ///< [constants] fitted in the end
  std::vector<bool> is_promised_;    ///< [constants] further lines would determine it
  Eigen::VectorXd widths_;           ///< [constants] of the 95 % intervals of the values
  int solves_ = 0;
};

/// As identify() of a scene, of a body that has its mesh.
[[nodiscard]] Identification identify(StrainedBody body, const Measurements& measured,
                                      const IdentificationOptions& options);

}  // namespace idiophone::fitting

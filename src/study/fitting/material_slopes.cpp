#include "idiophone/study/fitting/material_slopes.hpp"

#include <algorithm>

#include "elastic_constants.hpp"
#include "frequency_model.hpp"
#include "strain_products.hpp"

namespace idiophone::fitting {

MaterialSlopes material_slopes(const scene::Solids& solids, const mesh::Part& part,
                               const std::vector<eigenmodes::Mode>& modes) {
  const scene::Body& body = solids.bodies.front();
  const auto count = static_cast<Eigen::Index>(modes.size());
  if (!body.is_one_material_at_rest()) {
    return {{}, Eigen::VectorXd(0), Eigen::MatrixXd(count, 0)};
  }
  const scene::Material& material = solids.materials[body.material];
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(modes.front().shape.size()), count);
  for (Eigen::Index mode = 0; mode < count; ++mode) {
    shapes.col(mode) = Eigen::VectorXd::Map(modes[static_cast<std::size_t>(mode)].shape.data(), shapes.rows());
  }
  const StrainProducts products(part, shapes);
  std::vector<StrainedMode> strained;
  for (Eigen::Index mode = 0; mode < count; ++mode) {
    strained.push_back(
        {modes[static_cast<std::size_t>(mode)].frequency, products.of(Eigen::VectorXd::Unit(count, mode))});
  }
  const FrequencyModel model(strained, material, body.material_axes());
  const ElasticConstants constants = elastic_constants(material);
  const Eigen::MatrixXd of_multiplets = model.cents_slopes(constants, material);
  MaterialSlopes slopes{{}, Eigen::VectorXd(constants.size()), Eigen::MatrixXd(count, of_multiplets.cols())};
  std::ranges::transform(constants, std::back_inserter(slopes.names), &ElasticConstant::name);
  std::ranges::transform(constants, slopes.deviations.begin(), expected_deviation);
  for (std::size_t m = 0; m < model.multiplets().size(); ++m) {
    const Multiplet& multiplet = model.multiplets()[m];
    slopes.cents.middleRows(multiplet.first, multiplet.count).rowwise() =
        of_multiplets.row(static_cast<Eigen::Index>(m));
  }
  return slopes;
}

Eigen::VectorXd stable_part(const scene::Material& material, const Eigen::VectorXd& amounts) {
  constexpr int parts = 10;
  for (int part = parts; part > 0; --part) {
    Eigen::VectorXd less = part / static_cast<double>(parts) * amounts;
    if (is_stable(moved(material, less))) {
      return less;
    }
  }
  return Eigen::VectorXd::Zero(amounts.size());
}

scene::Material moved(const scene::Material& material, const Eigen::VectorXd& amounts) {
  const ElasticConstants constants = elastic_constants(material);
  return with_unknowns(constants, material, unknowns(constants, material) + amounts);
}

}  // namespace idiophone::fitting

#include "idiophone/foundation/stretching/stretching_energy.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "stretching_order.hpp"

namespace idiophone::stretching {

StretchingEnergy::Variables::Variables(std::size_t count, std::size_t blocks)
    : values((count + numbers_in_pack - 1) / numbers_in_pack * numbers_in_pack), slopes(values.size()) {
  ends.reserve(blocks);
}

void StretchingEnergy::Variables::add_block(std::span<const std::vector<float>> numbers) {
  for (std::size_t pack = 0; pack < values.size(); pack += numbers_in_pack) {
    Block block{};
    bool is_zero = true;
    for (std::size_t t = 0; t < terms_in_block; ++t) {
      for (std::size_t i = 0; i < numbers_in_pack && pack + i < numbers[t].size(); ++i) {
        block[t][i] = numbers[t][pack + i];
        is_zero &= block[t][i] == 0.0F;
      }
    }
    if (!is_zero) {
      coefficients.push_back(block);
      packs.push_back(pack);
    }
  }
  ends.push_back(coefficients.size());
}

StretchingEnergy::TermSums StretchingEnergy::Variables::sums(std::size_t block) const {
  Block sums{};
  for (std::size_t i = block == 0 ? 0 : ends[block - 1]; i < ends[block]; ++i) {
    Pack value;
    std::memcpy(&value, &values[packs[i]], sizeof(value));
    for (std::size_t t = 0; t < terms_in_block; ++t) {
      sums[t] += coefficients[i][t] * value;
    }
  }
  TermSums of_terms;
  std::ranges::transform(sums, of_terms.begin(), pairwise_sum_of_lanes<Pack>);
  return of_terms;
}

void StretchingEnergy::Variables::add_slopes(std::size_t block, const TermSums& of_terms) {
  std::array<float, terms_in_block> factors;
  std::ranges::transform(of_terms, factors.begin(), [](double factor) { return static_cast<float>(factor); });
  for (std::size_t i = block == 0 ? 0 : ends[block - 1]; i < ends[block]; ++i) {
    Pack slope;
    std::memcpy(&slope, &slopes[packs[i]], sizeof(slope));
    for (std::size_t t = 0; t < terms_in_block; ++t) {
      slope += coefficients[i][t] * factors[t];
    }
    std::memcpy(&slopes[packs[i]], &slope, sizeof(slope));
  }
}

StretchingEnergy::StretchingEnergy(std::span<const double> linear, std::span<const double> quadratic, std::size_t modes)
    : StretchingEnergy(linear, quadratic, modes,
                       stretching_order(quadratic, linear.size() / modes, modes, {terms_in_block, numbers_in_pack})) {}

StretchingEnergy::StretchingEnergy(std::span<const double> linear, std::span<const double> quadratic, std::size_t modes,
                                   const StretchingOrder& order)
    : modes_(modes),
      pairs_(order.pairs),
      places_(modes, order.terms.size() / terms_in_block + 1),
      products_(pairs_.size(), order.terms.size() / terms_in_block + 1),
      from_products_(places_.values.size()),
      slope_matrix_(modes * places_.values.size()) {
  const auto width = static_cast<std::uint32_t>(from_products_.size());
  std::ranges::transform(pairs_, std::back_inserter(matrix_places_), [width](const ModePair& pair) {
    return ModePair{pair.first * width + pair.second, pair.second * width + pair.first};
  });
  for (std::size_t first = 0; first < order.terms.size(); first += terms_in_block) {
    std::array<std::vector<float>, terms_in_block> of_places, of_products;
    for (std::size_t t = 0; t < terms_in_block && first + t < order.terms.size(); ++t) {
      const std::size_t term = order.terms[first + t];
      for (std::size_t mode = 0; mode < modes; ++mode) {
        of_places[t].push_back(static_cast<float>(linear[term * modes + mode]));
      }
      for (const auto& [i, j] : pairs_) {
        const double both = (i == j ? 1.0 : 2.0) * quadratic[(term * modes + i) * modes + j];
        of_products[t].push_back(static_cast<float>(both));
      }
    }
    places_.add_block(of_places);
    products_.add_block(of_products);
  }
}

double StretchingEnergy::at(std::span<const float> places, float bend, std::span<float> gradient) {
  std::ranges::transform(places, places_.values.begin(), [bend](float place) { return bend * place; });
  std::ranges::transform(pairs_, products_.values.begin(),
                         [&](const ModePair& pair) { return places[pair.first] * places[pair.second]; });
  std::ranges::fill(places_.slopes, 0.0F);
  std::ranges::fill(products_.slopes, 0.0F);
  double energy = 0.0;
  for (std::size_t block = 0; block < products_.ends.size(); ++block) {
    const TermSums z = products_.sums(block), a = places_.sums(block);
    TermSums slopes;
    std::ranges::transform(z, a, slopes.begin(), std::plus());
    places_.add_slopes(block, z);
    products_.add_slopes(block, slopes);
    for (std::size_t t = 0; t < terms_in_block; ++t) {
      energy += z[t] * (a[t] + z[t] / 2);
    }
  }
  multiply_slopes(places);
  std::ranges::transform(std::span(places_.slopes).first(modes_), std::span(from_products_).first(modes_),
                         gradient.begin(), [bend](float slope, float more) { return bend * slope + more; });
  return energy;
}

/// V changes by the sum over pairs of slope d(q_i q_j), the product of a symmetric matrix with q.
void StretchingEnergy::multiply_slopes(std::span<const float> places) {
  for (std::size_t pair = 0; pair < matrix_places_.size(); ++pair) {
    const auto [upper, lower] = matrix_places_[pair];
    slope_matrix_[upper] = slope_matrix_[lower] = products_.slopes[pair];
  }
  const std::size_t width = from_products_.size();
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    slope_matrix_[mode * (width + 1)] *= 2;
  }
  for (std::size_t pack = 0; pack < width; pack += numbers_in_pack) {
    Pack sum{};
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      Pack slope;
      std::memcpy(&slope, &slope_matrix_[mode * width + pack], sizeof(slope));
      sum += places[mode] * slope;
    }
    std::memcpy(&from_products_[pack], &sum, sizeof(sum));
  }
}

std::size_t StretchingEnergy::operations() const {
  return 2 * (products_.coefficients.size() + places_.coefficients.size()) * terms_in_block * numbers_in_pack;
}

std::size_t StretchingEnergy::bytes() const {
  const std::size_t blocks = products_.coefficients.size() + places_.coefficients.size();
  return blocks * (sizeof(Block) + sizeof(std::size_t)) + pairs_.size() * (2 * sizeof(ModePair) + 2 * sizeof(float)) +
         slope_matrix_.size() * sizeof(float);
}

}  // namespace idiophone::stretching

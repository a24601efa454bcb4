#pragma once
// The energy by which modes stretch their body, and its gradient, fast enough for each audio sample of `play` and each
// step of `run` (docs/method/large_amplitudes.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/foundation/vector_register.hpp"

namespace idiophone::stretching {

/// Two modes, or twice the same.
struct ModePair {
  std::uint32_t first = 0, second = 0;
};

struct StretchingOrder;

/// V = sum_n (a_n z_n + 1/2 z_n^2), a_n = A_n . q, z_n = q . H_n q, in single precision. The sum over a pair of modes
/// is computed once for both orders of the pair, and zeros of H cost nothing where all neighbours are zero.
class StretchingEnergy {
 public:
  /// @param linear     A, [terms x modes] J^1/2/(kg^1/2 m)
  /// @param quadratic  H, [terms x modes x modes] J^1/2/(kg m2), symmetric
  /// @param modes      1 to 65 000: pairs have 32-bit numbers. H of so many would take 30 GB a term
  StretchingEnergy(std::span<const double> linear, std::span<const double> quadratic, std::size_t modes);

  [[nodiscard]] std::size_t modes() const { return modes_; }

  /// V at q, J. No allocation. Uses the memory of this object: one thread at a time.
  /// @param places    q, [modes] kg^1/2 m
  /// @param bend      by which A is multiplied
  /// @param gradient  [modes] of V, J/(kg^1/2 m)
  double at(std::span<const float> places, float bend, std::span<float> gradient);

  /// Multiply-adds of one call.
  [[nodiscard]] std::size_t operations() const;

  /// Memory, bytes.
  [[nodiscard]] std::size_t bytes() const;

 private:
  StretchingEnergy(std::span<const double> linear, std::span<const double> quadratic, std::size_t modes,
                   const StretchingOrder& order);

  /// Numbers in single precision for as many modes, or pairs of modes, as fit into a register.
  using Pack = float __attribute__((vector_size(register_size)));
  static constexpr std::size_t numbers_in_pack = register_size / sizeof(float);
  static constexpr std::size_t terms_in_block = 4;
  /// Of terms that are computed at once.
  using Block = std::array<Pack, terms_in_block>;
  using TermSums = std::array<double, terms_in_block>;

  /// The coefficients of some variables, and the derivatives of V by these.
  struct Variables {
    Variables(std::size_t count, std::size_t blocks);
    /// @param numbers  [terms in a block][variables]
    void add_block(std::span<const std::vector<float>> numbers);
    [[nodiscard]] TermSums sums(std::size_t block) const;
    void add_slopes(std::size_t block, const TermSums& of_terms);

    std::vector<float> values, slopes;  // [variables], and zeros up to whole packs
    std::vector<Block> coefficients;    // those that are not all zero, block by block
    std::vector<std::size_t> packs;     // [coefficients] where their values begin
    std::vector<std::size_t> ends;      // [blocks] in the coefficients
  };

  /// Finds the gradient of the products of places from their slopes.
  void multiply_slopes(std::span<const float> places);

  std::size_t modes_;
  std::vector<ModePair> pairs_;  // in the order of their products
  Variables places_;
  Variables products_;
  std::vector<float> from_products_;     // [modes, and zeros up to whole packs] of the gradient
  std::vector<ModePair> matrix_places_;  // [pairs] of the slope matrix: of both orders of a pair
  std::vector<float> slope_matrix_;      // [modes x the same] slopes of the products of two places
};

}  // namespace idiophone::stretching

#pragma once
// One row of numbers on its way into an archive or out of it.

#include <cstddef>
#include <span>

namespace idiophone::parallel {

/// A class names the numbers of its state once, always in the same order; the action decides which way they go.
class ArchiveRow {
 public:
  enum class Action {
    count,  ///< only counts the numbers
    save,
    restore
  };

  /// @param values  the row as it is stored; empty for `count`
  explicit ArchiveRow(Action action, std::span<double> values = {}) : action_(action), values_(values) {}

  /// The next number: a floating-point number, or an integer of at most 53 bits.
  template <class Number>
  void value(Number& number) {
    switch (action_) {
      case Action::count:
        break;
      case Action::save:
        values_[count_] = static_cast<double>(number);
        break;
      case Action::restore:
        number = static_cast<Number>(values_[count_]);
        break;
    }
    ++count_;
  }

  /// The next numbers.
  template <class Numbers>
  void values(Numbers&& numbers) {
    for (auto& number : numbers) {
      value(number);
    }
  }

  /// Numbers named so far.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  Action action_;
  std::span<double> values_;
  std::size_t count_ = 0;
};

}  // namespace idiophone::parallel

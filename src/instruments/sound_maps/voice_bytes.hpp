#pragma once
// Numbers and texts as bytes, little-endian on every machine.

#include <array>
#include <bit>
#include <complex>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::sound_maps {

/// The unsigned whole number with the bits of a number.
template <class Number>
using BitsOf = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;

/// Calls an archive for each number of a value.
template <class Archive, class Number>
requires std::is_arithmetic_v<Number>
void each_number(Archive& archive, Number& number) {
  archive.number(number);
}
template <class Archive>
void each_number(Archive& archive, std::complex<double>& number) {
  auto& parts = reinterpret_cast<double(&)[2]>(number);  // as the standard lays it out
  archive.number(parts[0]);
  archive.number(parts[1]);
}
template <class Archive>
void each_number(Archive& archive, Vector3& vector) {
  for (double& coordinate : vector) {
    archive.number(coordinate);
  }
}
template <class Archive>
void each_number(Archive& archive, std::array<Index, 3>& triangle) {
  for (Index& vertex : triangle) {
    auto stored = static_cast<std::uint32_t>(vertex);
    archive.number(stored);
    vertex = static_cast<Index>(stored);
  }
}

/// Bytes that all values of a type have at least.
template <class Value>
constexpr std::size_t stored_size = std::is_same_v<Value, std::array<Index, 3>> ? 12 : sizeof(Value);

class ByteWriter {
 public:
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  template <class Number>
  void number(const Number& value) {
    const auto bits = std::bit_cast<BitsOf<Number>>(value);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bytes_.push_back(static_cast<char>(bits >> (8U * i)));
    }
  }
  void text(const std::string& text) {
    number(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  /// @return how many values follow
  std::size_t count(std::size_t present, std::size_t /*size*/) {
    number(static_cast<std::uint64_t>(present));
    return present;
  }

 private:
  std::string bytes_;
};

/// Never reads beyond the bytes, and never asks for more memory than they can fill.
class ByteReader {
 public:
  explicit ByteReader(std::span<const char> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::span<const char> rest() const { return bytes_; }

  template <class Number>
  void number(Number& value) {
    BitsOf<Number> bits = 0;
    const std::span<const char> taken = take(sizeof(Number));
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bits |= static_cast<BitsOf<Number>>(static_cast<unsigned char>(taken[i])) << (8U * i);
    }
    value = std::bit_cast<Number>(bits);
  }
  void text(std::string& text) {
    const std::span<const char> taken = take(count(0, 1));
    text.assign(taken.begin(), taken.end());
  }
  /// @param size  of one value, bytes
  std::size_t count(std::size_t /*present*/, std::size_t size) {
    std::uint64_t count = 0;
    number(count);
    if (count > bytes_.size() / size) {
      throw std::runtime_error("it ends too early");
    }
    return count;
  }
  std::span<const char> take(std::size_t size) {
    if (size > bytes_.size()) {
      throw std::runtime_error("it ends too early");
    }
    const std::span<const char> taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }

 private:
  std::span<const char> bytes_;
};

/// The number of values, and each of them.
template <class Archive, class Value>
void each_value(Archive& archive, std::vector<Value>& values) {
  values.resize(archive.count(values.size(), stored_size<Value>));
  for (Value& value : values) {
    each_number(archive, value);
  }
}

}  // namespace idiophone::sound_maps

#pragma once
// Flat files for programs without HDF5: 16 bytes that name the kind, a version (4 bytes), a checksum of all that
// follows (8 bytes), and the contents. Numbers have the least byte first on every machine.

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <complex>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone {

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
template <class Archive, class Number, std::size_t count>
void each_number(Archive& archive, std::array<Number, count>& numbers) {
  for (Number& number : numbers) {
    archive.number(number);
  }
}

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
  /// @throws std::runtime_error when bytes are left
  void end() const {
    if (!bytes_.empty()) {
      throw std::runtime_error("something follows its end");
    }
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
  values.resize(archive.count(values.size(), sizeof(Value)));
  for (Value& value : values) {
    each_number(archive, value);
  }
}

/// What flat files of one kind begin with.
struct FlatKind {
  std::string_view magic;      ///< 16 bytes
  std::uint32_t version;       ///< that is written and read
  std::string_view made_with;  ///< the command that makes such a file, for messages
};

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo). It finds damage, not ill will.
[[nodiscard]] inline std::uint64_t flat_checksum(std::span<const char> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char byte : bytes) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  return sum;
}

/// The bytes of the whole file.
[[nodiscard]] inline std::string flat_file(const FlatKind& kind, const ByteWriter& contents) {
  ByteWriter head;
  head.number(kind.version);
  head.number(flat_checksum(contents.bytes()));
  return std::string(kind.magic) + head.bytes() + contents.bytes();
}

/// @param bytes  of the whole file
/// @throws std::runtime_error when it is of another kind or version, or damaged
[[nodiscard]] inline ByteReader flat_contents(const FlatKind& kind, std::span<const char> bytes) {
  ByteReader reader(bytes);
  if (!std::ranges::equal(reader.take(std::min(bytes.size(), kind.magic.size())), kind.magic)) {
    throw std::runtime_error("it does not begin as one; `" + std::string(kind.made_with) + "` makes one");
  }
  std::uint32_t version = 0;
  std::uint64_t sum = 0;
  reader.number(version);
  if (version != kind.version) {
    throw std::runtime_error("it has the version " + std::to_string(version) + ", and this library reads version " +
                             std::to_string(kind.version) + "; export it again");
  }
  reader.number(sum);
  if (sum != flat_checksum(reader.rest())) {
    throw std::runtime_error("its checksum is wrong, so it is damaged");
  }
  return reader;
}

/// All bytes of a file. @throws std::runtime_error when it can't be read
[[nodiscard]] inline std::string read_bytes(const std::filesystem::path& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    throw std::runtime_error("can't read " + path.string() + ": it is no file");
  }
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) {
    throw std::runtime_error("can't read " + path.string() + ": " + std::strerror(errno));
  }
  return bytes;
}

}  // namespace idiophone

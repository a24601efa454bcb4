#pragma once
// MPI's datatypes: of numbers, and of structs and rows sent as they lie in memory.

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace idiophone::parallel {

/// MPI's own type of a number.
template <class Number>
[[nodiscard]] MPI_Datatype number_type() {
  if constexpr (std::is_same_v<Number, double>) {
    return MPI_DOUBLE;
  } else if constexpr (std::is_same_v<Number, float>) {
    return MPI_FLOAT;
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return MPI_INT64_T;
  } else if constexpr (std::is_same_v<Number, std::uint64_t>) {
    return MPI_UINT64_T;
  } else {
    static_assert(std::is_same_v<Number, std::int32_t>, "no MPI type is known for this number");
    return MPI_INT32_T;
  }
}

/// A committed type of some equal items in a row, freed at the end. Messages then count rows, not bytes, so that their
/// counts fit MPI's int.
class Datatype {
 public:
  Datatype(std::size_t count, MPI_Datatype item) {
    MPI_Type_contiguous(static_cast<int>(count), item, &type_);
    MPI_Type_commit(&type_);
  }
  /// So many bytes. The ranks of a job run the same binary, so bytes mean the same on all.
  [[nodiscard]] static Datatype bytes(std::size_t count) { return {count, MPI_BYTE}; }
  /// One value of a type without pointers of its own.
  template <class Value>
  [[nodiscard]] static Datatype of() {
    static_assert(std::is_trivially_destructible_v<Value>, "values with pointers of their own can't be sent");
    return bytes(sizeof(Value));
  }

  Datatype(const Datatype&) = delete;
  Datatype& operator=(const Datatype&) = delete;
  Datatype(Datatype&& other) noexcept : type_(std::exchange(other.type_, MPI_DATATYPE_NULL)) {}
  Datatype& operator=(Datatype&& other) noexcept {
    std::swap(type_, other.type_);
    return *this;
  }
  ~Datatype() {
    if (type_ != MPI_DATATYPE_NULL) {
      MPI_Type_free(&type_);
    }
  }

  [[nodiscard]] MPI_Datatype get() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

/// The type of one item of a message: MPI's own for doubles, bytes for all others.
template <class Value>
class ItemType {
 public:
  [[nodiscard]] MPI_Datatype get() const { return type_.get(); }

 private:
  Datatype type_ = Datatype::of<Value>();
};

template <>
class ItemType<double> {
 public:
  [[nodiscard]] static MPI_Datatype get() { return MPI_DOUBLE; }
};

}  // namespace idiophone::parallel

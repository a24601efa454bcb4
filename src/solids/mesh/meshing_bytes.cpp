// Requests and answers as bytes: every list is preceded by its length, which is checked against the bytes that are
// left; a mark at the end shows that nothing is missing. Both programs are of the same build, so numbers travel as they
// are in memory.

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesh {

namespace {

constexpr std::uint64_t end_mark = 0x1d10f03e5ea1ed00;

class Writer {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(const Number& number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number)); }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  template <class Item>
  void operator()(const std::vector<Item>& items) {
    (*this)(static_cast<std::uint64_t>(items.size()));
    if constexpr (std::is_arithmetic_v<Item>) {
      bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
    } else {
      for (const Item& item : items) {
        (*this)(item);
      }
    }
  }
  void operator()(const std::map<std::string, double>& numbers) {
    (*this)(static_cast<std::uint64_t>(numbers.size()));
    for (const auto& [name, value] : numbers) {
      (*this)(name);
      (*this)(value);
    }
  }
  template <class Record>
  requires std::is_class_v<Record>
  void operator()(const Record& record) { archive(*this, record); }
  [[nodiscard]] std::string& bytes() { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : next_(bytes.data()), end_(bytes.data() + bytes.size()) {}

  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(Number& number) { copy(&number, sizeof(number)); }
  void operator()(std::string& text) {
    text.resize(count(1));
    copy(text.data(), text.size());
  }
  template <class Item>
  void operator()(std::vector<Item>& items) {
    if constexpr (std::is_arithmetic_v<Item>) {
      items.resize(count(sizeof(Item)));
      copy(items.data(), items.size() * sizeof(Item));
    } else {
      for (std::size_t left = count(1); left > 0; --left) {
        (*this)(items.emplace_back());
      }
    }
  }
  void operator()(std::map<std::string, double>& numbers) {
    for (std::size_t left = count(1); left > 0; --left) {
      std::string name;
      (*this)(name);
      (*this)(numbers[name]);
    }
  }
  template <class Record>
  requires std::is_class_v<Record>
  void operator()(Record& record) { archive(*this, record); }
  [[nodiscard]] bool is_at_end() const { return next_ == end_; }

 private:
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - next_); }

  /// A list's length, which the bytes that are left must be able to hold.
  std::size_t count(std::size_t item_size) {
    std::uint64_t value = 0;
    (*this)(value);
    if (value > left() / item_size) {
      throw std::runtime_error("its answer is cut short");
    }
    return value;
  }
  void copy(void* target, std::size_t size) {
    if (size > left()) {
      throw std::runtime_error("its answer is cut short");
    }
    if (size > 0) {
      std::memcpy(target, next_, size);
      next_ += size;
    }
  }
  const char* next_;
  const char* end_;
};

/// Calls the archive with every member of a record: Record is const for a Writer, and not for a Reader.
template <class Archive, class Record>
void archive(Archive& each, Record& record) {
  using Type = std::remove_const_t<Record>;
  if constexpr (std::is_same_v<Type, MeshingRequest>) {
    each(record.file), each(record.format), each(record.object), each(record.parameters);
    each(record.hexahedra);
    each(record.dimension), each(record.lowest_order), each(record.highest_order);
    each(record.attempt), each(record.wrap), each(record.gap), each(record.memory_limit);
  } else if constexpr (std::is_same_v<Type, ElementBlock>) {
    each(record.type_name), each(record.type), each(record.width), each(record.element_tags), each(record.node_tags);
  } else if constexpr (std::is_same_v<Type, GroupBlock>) {
    each(record.name), each(record.tag), each(record.node_tags), each(record.triangles);
    each(record.elements);
  } else if constexpr (std::is_same_v<Type, ViewBlock>) {
    each(record.name), each(record.of_elements), each(record.steps), each(record.tags), each(record.values);
  } else if constexpr (std::is_same_v<Type, Objection>) {
    each(record.parameter), each(record.message);
  } else {
    static_assert(std::is_same_v<Type, MeshingAnswer>);
    each(record.objections), each(record.node_tags), each(record.coordinates), each(record.elements);
    each(record.groups), each(record.views), each(record.notes);
  }
}

template <class Record>
std::string write(const Record& record) {
  Writer writer;
  writer(record);
  writer(end_mark);
  return std::move(writer.bytes());
}

template <class Record>
Record read(const std::string& bytes) {
  Reader reader(bytes);
  Record record;
  reader(record);
  std::uint64_t mark = 0;
  reader(mark);
  if (mark != end_mark || !reader.is_at_end()) {
    throw std::runtime_error("its answer makes no sense");
  }
  return record;
}

}  // namespace

std::string to_bytes(const MeshingRequest& request) {
  return write(request);
}

std::string to_bytes(const MeshingAnswer& answer) {
  return write(answer);
}

MeshingRequest request_from(const std::string& bytes) {
  return read<MeshingRequest>(bytes);
}

MeshingAnswer answer_from(const std::string& bytes) {
  return read<MeshingAnswer>(bytes);
}

}  // namespace idiophone::mesh

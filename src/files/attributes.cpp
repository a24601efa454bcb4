#include "idiophone/files/attributes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::hdf5 {

namespace {

/// Texts as HDF5 stores them: all of one length, ended by zeros.
struct Packed {
  std::size_t length = 1;
  std::size_t count = 0;
  std::vector<char> characters = {};
};

Packed pack(const std::vector<std::string>& texts) {
  Packed packed{.count = texts.size()};
  for (const auto& text : texts) {
    packed.length = std::max(packed.length, text.size() + 1);
  }
  packed.characters.resize(std::max<std::size_t>(packed.length * texts.size(), 1));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::ranges::copy(texts[i], packed.characters.begin() + static_cast<std::ptrdiff_t>(i * packed.length));
  }
  return packed;
}

std::vector<std::string> unpack(const Packed& packed) {
  std::vector<std::string> texts(packed.count);
  for (std::size_t i = 0; i < packed.count; ++i) {
    const auto* const begin = &packed.characters[i * packed.length];
    texts[i].assign(begin, strnlen(begin, packed.length));
  }
  return texts;
}

Identifier text_type(std::size_t length) {
  Identifier type(H5Tcopy(H5T_C_S1), H5Tclose, "HDF5 text type");
  check(H5Tset_size(type.id(), length), "HDF5 text type");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "HDF5 text type");
  return type;
}

Identifier attribute_space(const Dimensions& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "HDF5 data space"};
}

void put_bytes(hid_t object, const std::string& name, hid_t type, const Dimensions& shape, const void* values) {
  const auto action = fmt::format("can't write attribute {}", name);
  const auto space = attribute_space(shape);
  const Identifier attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                             action);
  check(H5Awrite(attribute.id(), type, values), action);
}

Identifier open_attribute(hid_t object, const std::string& name) {
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, fmt::format("can't read attribute {}", name)};
}

/// The one number of an attribute.
template <class T>
T single(hid_t object, const std::string& name) {
  const auto attribute = open_attribute(object, name);
  const auto space = space_of_attribute(attribute.id(), name);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) {
    throw std::runtime_error(fmt::format("attribute {} is not one number", name));
  }
  T value{};
  check(H5Aread(attribute.id(), type_of<T>(), &value), fmt::format("can't read attribute {}", name));
  return value;
}

/// Makes room for the texts of an attribute or dataset.
Packed room_for_texts(hid_t stored_type, hid_t space, const std::string& name) {
  if (H5Tget_class(stored_type) != H5T_STRING) {
    throw std::runtime_error(fmt::format("{} is not text", name));
  }
  Packed packed{.length = H5Tget_size(stored_type),
                .count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0))};
  packed.characters.resize(std::max<std::size_t>(packed.length * packed.count, 1));
  return packed;
}

/// Texts of any length, as other programs store them.
/// @param read  fills an array of pointers to them
template <class Read>
std::vector<std::string> variable_texts(const Identifier& type, const Identifier& space, const Read& read) {
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0));
  std::vector<char*> pointers(count, nullptr);
  read(pointers.data());
  std::vector<std::string> texts;
  texts.reserve(count);
  for (const char* text : pointers) {
    texts.emplace_back(text == nullptr ? "" : text);
  }
  H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
  return texts;
}

}  // namespace

Identifier space_of_attribute(hid_t attribute, const std::string& name) {
  constexpr hssize_t most_values = 1'000'000;
  Identifier space(H5Aget_space(attribute), H5Sclose, name);
  if (const hssize_t values = H5Sget_simple_extent_npoints(space.id()); values > most_values) {
    throw std::runtime_error(fmt::format("attribute {} has {} values", name, values));
  }
  return space;
}

void put(hid_t object, const std::string& name, const std::string& text) {
  const auto packed = pack({text});
  put_bytes(object, name, text_type(packed.length).id(), {}, packed.characters.data());
}

void put(hid_t object, const std::string& name, const std::vector<std::string>& texts) {
  const auto packed = pack(texts);
  put_bytes(object, name, text_type(packed.length).id(), {texts.size()}, packed.characters.data());
}

void put(hid_t object, const std::string& name, std::int64_t number) {
  put_bytes(object, name, H5T_NATIVE_INT64, {}, &number);
}

void put(hid_t object, const std::string& name, double number) {
  put_bytes(object, name, H5T_NATIVE_DOUBLE, {}, &number);
}

void put(hid_t object, const std::string& name, const std::vector<std::array<double, 3>>& points) {
  put_bytes(object, name, H5T_NATIVE_DOUBLE, {points.size(), 3}, points.data());
}

void replace(hid_t object, const std::string& name, std::int64_t number) {
  check(H5Awrite(open_attribute(object, name).id(), H5T_NATIVE_INT64, &number),
        fmt::format("can't write attribute {}", name));
}

std::vector<std::string> attribute_names(hid_t object) {
  const auto collect = [](hid_t /*object*/, const char* name, const H5A_info_t* /*attribute*/, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> names;
  check(H5Aiterate2(object, H5_INDEX_NAME, any_order, nullptr, collect, &names), "can't list the attributes");
  std::ranges::sort(names);
  return names;
}

bool has(hid_t object, const std::string& name) {
  const auto exists = H5Aexists(object, name.c_str());
  check(exists, "can't read the attributes");
  return exists > 0;
}

std::string text_of(hid_t object, const std::string& name) {
  const auto texts = texts_of(object, name);
  if (texts.size() != 1) {
    throw std::runtime_error(fmt::format("attribute {} is not one text", name));
  }
  return texts[0];
}

std::vector<std::string> texts_of(hid_t object, const std::string& name) {
  const auto attribute = open_attribute(object, name);
  const Identifier type(H5Aget_type(attribute.id()), H5Tclose, name);
  const auto space = space_of_attribute(attribute.id(), name);
  if (H5Tis_variable_str(type.id()) > 0) {
    return variable_texts(type, space, [&](char** texts) {
      check(H5Aread(attribute.id(), type.id(), static_cast<void*>(texts)),
            fmt::format("can't read attribute {}", name));
    });
  }
  auto packed = room_for_texts(type.id(), space.id(), name);
  check(H5Aread(attribute.id(), type.id(), packed.characters.data()), fmt::format("can't read attribute {}", name));
  return unpack(packed);
}

std::int64_t integer_of(hid_t object, const std::string& name) {
  return single<std::int64_t>(object, name);
}

double number_of(hid_t object, const std::string& name) {
  return single<double>(object, name);
}

std::vector<std::array<double, 3>> points_of(hid_t object, const std::string& name) {
  const auto attribute = open_attribute(object, name);
  const auto space = space_of_attribute(attribute.id(), name);
  const Dimensions shape = shape_of_space(space.id());
  if (shape.size() != 2 || shape[1] != 3) {
    throw std::runtime_error(fmt::format("attribute {} does not hold points", name));
  }
  std::vector<std::array<double, 3>> points(shape[0]);
  if (points.empty()) {
    return points;  // HDF5 reads no empty attributes
  }
  check(H5Aread(attribute.id(), type_of<double>(), points.data()), fmt::format("can't read attribute {}", name));
  return points;
}

void put_dataset(hid_t file, const std::string& path, const std::vector<std::string>& texts, MPI_Comm communicator) {
  const auto packed = pack(texts);
  const auto type = text_type(packed.length);
  const auto dataset = create_dataset(file, path, type.id(), {texts.size()});
  const auto bytes = std::as_bytes(std::span(packed.characters)).first(packed.length * packed.count);
  put(dataset.id(), files::checksum_attribute, std::int64_t{files::checksum(bytes)});
  if (parallel::is_root(communicator) && !texts.empty()) {
    write_bytes(dataset.id(), whole(dataset.id()), type.id(), packed.characters.data(), Transfer::alone);
  }
}

std::vector<std::string> texts_in(hid_t file, const std::string& path) {
  const auto dataset = open_dataset(file, path);
  const Identifier type(H5Dget_type(dataset.id()), H5Tclose, path);
  const Identifier space(H5Dget_space(dataset.id()), H5Sclose, path);
  static_cast<void>(stored_volume(dataset.id(), whole(dataset.id())));
  if (H5Tis_variable_str(type.id()) > 0) {
    return variable_texts(type, space, [&](char** texts) {
      read_bytes(dataset.id(), whole(dataset.id()), type.id(), static_cast<void*>(texts));
    });
  }
  auto packed = room_for_texts(type.id(), space.id(), path);
  read_bytes(dataset.id(), whole(dataset.id()), type.id(), packed.characters.data());
  const auto bytes = std::as_bytes(std::span(packed.characters)).first(packed.length * packed.count);
  if (has(dataset.id(), files::checksum_attribute) &&
      integer_of(dataset.id(), files::checksum_attribute) != std::int64_t{files::checksum(bytes)}) {
    throw std::runtime_error(fmt::format("{} does not match its checksum: the file is damaged", path));
  }
  return unpack(packed);
}

std::string text_in(hid_t file, const std::string& path) {
  const auto texts = texts_in(file, path);
  if (texts.size() != 1) {
    throw std::runtime_error(fmt::format("dataset {} is not one text", path));
  }
  return texts[0];
}

}  // namespace idiophone::hdf5

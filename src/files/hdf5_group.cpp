#include "idiophone/files/hdf5_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace idiophone::hdf5 {

bool exists(hid_t file, const std::string& path) {
  return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

void remove(hid_t file, const std::string& path) {
  check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), fmt::format("can't remove {}", path));
}

Identifier open_group(hid_t file, const std::string& path) {
  const auto action = fmt::format("can't open group {}", path);
  Identifier group(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, action);
  std::istringstream names(path.substr(1));
  for (std::string name; std::getline(names, name, '/');) {
    const bool exists = H5Lexists(group.id(), name.c_str(), H5P_DEFAULT) > 0;
    group = {exists ? H5Gopen2(group.id(), name.c_str(), H5P_DEFAULT)
                    : H5Gcreate2(group.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
             H5Gclose, action};
  }
  return group;
}

std::vector<std::string> names_in(hid_t group) {
  const auto collect = [](hid_t /*group*/, const char* name, const H5L_info_t* /*link*/, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> names;
  check(H5Literate(group, H5_INDEX_NAME, any_order, nullptr, collect, &names), "can't list a group");
  std::ranges::sort(names);
  return names;
}

std::vector<Entry> entries_of(hid_t group) {
  const auto collect = [](hid_t holder, const char* name, const H5L_info_t* /*link*/, void* list) -> herr_t {
    ObjectInfo object;
    if (H5Oget_info_by_name2(holder, name, &object, H5O_INFO_BASIC, H5P_DEFAULT) < 0) {
      return -1;
    }
    static_cast<std::vector<Entry>*>(list)->push_back({name, object.type == H5O_TYPE_GROUP});
    return 0;
  };
  std::vector<Entry> entries;
  check(H5Literate(group, H5_INDEX_NAME, any_order, nullptr, collect, &entries), "can't list a group");
  std::ranges::sort(entries, {}, &Entry::name);
  return entries;
}

std::vector<std::string> datasets_below(hid_t file, const std::string& group) {
  std::vector<std::string> paths;
  if (group != "/" && !exists(file, group)) {
    return paths;
  }
  const auto collect = [](hid_t /*group*/, const char* name, const ObjectInfo* object, void* list) -> herr_t {
    if (object->type == H5O_TYPE_DATASET) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    }
    return 0;
  };
  check(H5Ovisit_by_name2(file, group.c_str(), H5_INDEX_NAME, any_order, collect, &paths, H5O_INFO_BASIC, H5P_DEFAULT),
        fmt::format("can't list {}", group));
  for (auto& path : paths) {
    path.insert(0, group == "/" ? "/" : group + "/");
  }
  std::ranges::sort(paths);
  return paths;
}

}  // namespace idiophone::hdf5

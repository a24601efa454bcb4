// The resolved deck as YAML.

#include <yaml-cpp/emitter.h>
#include <yaml-cpp/emittermanip.h>

#include <algorithm>

#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::deck {

namespace {

void emit(YAML::Emitter& yaml, const Node& node);

void emit_entries(YAML::Emitter& yaml, const std::vector<Node>& entries) {
  for (const Node& entry : entries) {
    if (entry.kind != Node::Kind::nothing) {
      yaml << YAML::Key << entry.key << YAML::Value;
      emit(yaml, entry);
    }
  }
}

void emit_list(YAML::Emitter& yaml, const Node& list) {
  const auto is_map = [](const Node& item) { return item.kind == Node::Kind::map; };
  yaml << (std::ranges::any_of(list.children, is_map) ? YAML::Block : YAML::Flow) << YAML::BeginSeq;
  for (const Node& item : list.children) {
    emit(yaml, item);
  }
  yaml << YAML::EndSeq;
}

void emit(YAML::Emitter& yaml, const Node& node) {
  switch (node.kind) {
    case Node::Kind::nothing:
      yaml << YAML::Null;
      return;
    case Node::Kind::scalar:
      if (node.quoted) {
        yaml << YAML::DoubleQuoted;
      }
      yaml << (node.file.empty() ? node.text : node.file);
      return;
    case Node::Kind::list:
      emit_list(yaml, node);
      return;
    case Node::Kind::map:
      yaml << YAML::BeginMap;
      emit_entries(yaml, node.children);
      emit_entries(yaml, node.defaults);
      yaml << YAML::EndMap;
  }
}

}  // namespace

std::string resolved(const Node& tree) {
  YAML::Emitter yaml;
  emit(yaml, tree);
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace idiophone::deck

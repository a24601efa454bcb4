#include "idiophone/scene/scene_file.hpp"

#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::scene {

Node read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides, Scene& scene,
                     const std::function<void(Section& section)>& read_rest) {
  scene.deck = file;
  scene.deck_text = deck::read_text(file);
  scene.overrides = overrides;
  Mistakes mistakes;
  Node tree = deck::read_tree(scene.deck_text, file.string(), overrides, mistakes);
  Section section(tree, mistakes);
  if (section.required("name", scene.name)) {
    check_name(scene.name, section.find("name")->where, mistakes);
  }
  read_rest(section);
  section.finish();
  check_listeners(scene, mistakes);
  mistakes.raise();
  return tree;
}

}  // namespace idiophone::scene

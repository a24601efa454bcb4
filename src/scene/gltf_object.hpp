#pragma once
// What a glTF file says of an object besides its shape.

#include <filesystem>
#include <optional>
#include <string>

namespace idiophone::scene {

/// The material is the acoustic one of KHR_audio_rigid_bodies where the file has that, else the one that is seen. The
/// mass is the one of KHR_physics_rigid_bodies where the file has that, else the one of KHR_audio_rigid_bodies.
struct FileObject {
  std::string material;           ///< its name; empty: none, or several
  std::optional<double> density;  ///< kg/m3, of an acoustic material
  std::optional<double> young;    ///< Pa, likewise
  std::optional<double> poisson;  ///< likewise
  std::optional<double> mass;     ///< kg
};

/// Whether the path ends as those of glTF files.
[[nodiscard]] bool is_gltf(const std::filesystem::path& file);

/// @param object  name of a node or a mesh, which stands for its descendants, too; none: the whole file
/// @throws std::runtime_error when the file can't be read, or has no such object; the
///         message continues a sentence that begins with the file's name
[[nodiscard]] FileObject object_in_gltf(const std::filesystem::path& file, const std::optional<std::string>& object);

/// The constants that an acoustic material has, as in a deck: "young: 2e+11, poisson: 0.3, density: 7850". Constants
/// that it lacks are "...".
[[nodiscard]] std::string constants_in_words(const FileObject& object);

}  // namespace idiophone::scene

#pragma once
// Names in recordings of surface motion, for writer and reader.

#include <string>

namespace idiophone::results::surface_motion {

inline const std::string triangles = "/triangles";                     // [triangles x 3]
inline const std::string reference = "/reference";                     // [vertices x 3]
inline const std::string pressure = "/pressure";                       // [rows x triangles]
inline const std::string position = "/position";                       // [rows x vertices x 3]
inline const std::string segments = "/segments";                       // NUMBER/triangles, pressure, position
inline const std::string body_names = "/bodies/name";                  // [bodies]
inline const std::string first_triangles = "/bodies/triangle";         // [bodies]
inline const std::string first_vertices = "/bodies/vertex";            // [bodies]
inline const std::string obstacle_triangles = "/obstacles/triangles";  // [9 x triangles]
inline const std::string half_spaces = "/obstacles/half_spaces";       // [6 x half-spaces]

}  // namespace idiophone::results::surface_motion

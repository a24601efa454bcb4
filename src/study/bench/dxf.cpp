#include <fmt/format.h>

#include "idiophone/study/bench/cut_drawing.hpp"

namespace idiophone::bench {

namespace {

/// A code and its value, each on a line of its own.
std::string group(int code, const std::string& value) {
  return fmt::format("{:>3}\n{}\n", code, value);
}

/// A coordinate or length, m.
std::string length(int code, double value) {
  return group(code, fmt::format("{:.6f}", 1e3 * value));
}

std::string table_of(const std::vector<Layer>& layers) {
  std::string text = group(0, "SECTION") + group(2, "TABLES") + group(0, "TABLE") + group(2, "LAYER") +
                     group(70, std::to_string(layers.size()));
  int colour = 7;
  for (const Layer& layer : layers) {
    text += group(0, "LAYER") + group(2, layer.name) + group(70, "0") + group(62, std::to_string(colour)) +
            group(6, "CONTINUOUS");
    colour = 1;  // what is cut now is red
  }
  return text + group(0, "ENDTAB") + group(0, "ENDSEC");
}

std::string polyline_of(const Layer& layer) {
  constexpr const char* closed = "1";
  std::string text = group(0, "POLYLINE") + group(8, layer.name) + group(66, "1") + length(10, 0) + length(20, 0) +
                     length(30, 0) + group(70, closed);
  for (const auto& [along, height] : layer.profile) {
    text += group(0, "VERTEX") + group(8, layer.name) + length(10, along) + length(20, height) + length(30, 0);
  }
  return text + group(0, "SEQEND") + group(8, layer.name);
}

}  // namespace

std::string dxf_of(const std::vector<Layer>& layers) {
  std::string text = group(999, "side view, in mm") + group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") +
                     group(1, "AC1009") + group(0, "ENDSEC") + table_of(layers) + group(0, "SECTION") +
                     group(2, "ENTITIES");
  for (const Layer& layer : layers) {
    text += polyline_of(layer);
  }
  return text + group(0, "ENDSEC") + group(0, "EOF");
}

}  // namespace idiophone::bench

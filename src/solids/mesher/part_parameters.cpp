#include "part_parameters.hpp"

namespace idiophone::mesher {

double scale_of(const mesh::MeshingRequest& request) {
  const auto scale = request.parameters.find("scale");
  return request.format == mesh::FileFormat::geo || scale == request.parameters.end() ? 1.0 : scale->second;
}

std::optional<double> size_of(const mesh::MeshingRequest& request) {
  const auto size = request.parameters.find("size");
  return size == request.parameters.end() ? std::nullopt : std::optional(size->second / scale_of(request));
}

}  // namespace idiophone::mesher

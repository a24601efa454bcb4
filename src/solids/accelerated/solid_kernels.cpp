#include "solid_kernels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "solid_kernel_files.hpp"

namespace idiophone::accelerated {

namespace {

/// An array in OpenCL C. Hexadecimal digits keep all bits.
std::string table(const char* name, const std::vector<double>& values) {
  return fmt::format("constant double {}[] = {{{:a}}};\n", name, fmt::join(values, ", "));
}

std::vector<double> by_rows(const Eigen::MatrixXd& matrix) {
  std::vector<double> values;
  for (const auto& row : matrix.rowwise()) {
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

std::string element_tables(element::Type type) {
  const auto& quadrature = element::reference(type).quadrature;
  std::vector<double> weights, gradients;
  for (const element::QuadraturePoint& point : quadrature) {
    weights.push_back(point.weight);
    const std::vector<double> rows = by_rows(point.gradient);
    gradients.insert(gradients.end(), rows.begin(), rows.end());
  }
  std::string text = "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n" + table("weights", weights);
  if (element::lines_through(type) == 0) {
    return text + table("gradients", gradients);
  }
  text += fmt::format("#define PLANE {}\n#define THICKNESS {}\n", type.plane + 1, type.thickness + 1);
  text += table("along_plane", by_rows(element::lobatto(type.plane).derivative));
  return text + table("along_thickness", by_rows(element::lobatto(type.thickness).derivative));
}

std::string source(element::Type type, const LawSize& law) {
  std::string text = fmt::format(
      "#define NODES {}\n#define POINTS {}\n#define RATES {:d}\n#define MECHANISMS {}\n#define LAW {}\n"
      "#define MATERIAL {}\n",
      element::node_count(type), element::reference(type).quadrature.size(), law.has_rates, law.mechanisms,
      law_in_material, material_length(law));
  text += element_tables(type);
  for (const std::string_view file :
       {element::lines_through(type) > 0 ? hexahedra_file : tetrahedra_file, entries_file, elements_file, nodes_file}) {
    text += file;
  }
  return text;
}

}  // namespace

SolidKernels::SolidKernels(accelerator::Accelerator& accelerator, element::Type type, const LawSize& law)
    : program(accelerator, source(type, law)),
      stress_points(program, "stress_points"),
      advance_nodes(program, "advance_nodes"),
      push_nodes(program, "push_nodes"),
      displace_nodes(program, "displace_nodes"),
      gather_motion(program, "gather_motion"),
      scatter_motion(program, "scatter_motion") {}

}  // namespace idiophone::accelerated

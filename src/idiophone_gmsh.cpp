// idiophone_gmsh: runs gmsh on one geometry file, for idiophone only.

#include "idiophone/solids/mesher/mesher_program.hpp"

int main(int argument_count, char** arguments) {
  return idiophone::mesher::run_program(argument_count, arguments);
}

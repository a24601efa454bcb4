// idiophone: the exact sound of struck, plucked, dropped and bent solids.

#include "idiophone/app/program.hpp"

int main(int argument_count, char** arguments) {
  return idiophone::app::run_program(argument_count, arguments);
}

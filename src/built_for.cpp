// Compiled as the rest of the program is.

#include "instruction_set.hpp"

#define IDIOPHONE_TEXT_OF(name) #name
#define IDIOPHONE_TEXT(macro) IDIOPHONE_TEXT_OF(macro)  // "1" if the macro is defined, its name if not
#define IDIOPHONE_BIT(number, name, macro) | (IDIOPHONE_TEXT(macro)[0] == '1' ? 1U << (number) : 0U)

extern const unsigned idiophone_built_for = 0U IDIOPHONE_INSTRUCTIONS(IDIOPHONE_BIT);

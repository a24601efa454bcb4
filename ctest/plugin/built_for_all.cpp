// As if the plugin were built for all instructions of the list.

#include "instruction_set.hpp"

extern const unsigned idiophone_built_for = ~0U;

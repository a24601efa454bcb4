#pragma once

/// Whether the program was built for instructions that this processor lacks. Says on the standard error which.
bool idiophone_lacks_instructions();

#pragma once

// What translation units built for different instruction sets include is inlined by force, since a shared out-of-line
// copy could be taken from the unit with the newest instructions.
#define IFEDEM_INLINE [[gnu::always_inline]] inline

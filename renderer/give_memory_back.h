// A compiler takes a hundred megabytes and more for a moment, in small pieces. What it leaves between those that stay, the
// C library keeps by itself, and whatever comes and goes later wanders all over it: after an hour that was as much as all
// that was in use, and where several programs are compiled in a row it adds up.
#pragma once

#include <cstdlib>  // which tells of glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace relievo {

// To look for it takes some milliseconds.
inline void give_memory_back() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace relievo

#pragma once
// Loops over particles are vectorised, and how many particles stand before one decides whether it is computed in a
// vector or in the rest. Left free, the compiler fuses other products with sums in one than in the other, and the last
// digit would hang on which particles a rank has. So these loops fuse none, which leaves every operation rounded as
// IEEE 754 says. Loops that take a whole pack at a time, the rest too, are free to.

#ifdef __clang__  // does not know it
#define TEKTITE_UNFUSED
#else
#define TEKTITE_UNFUSED [[gnu::optimize("fp-contract=off")]]
#endif

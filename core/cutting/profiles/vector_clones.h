// SPDX-License-Identifier: GPL-3.0-or-later
// Marks a function of inner loops: the compiler makes one version per instruction set, and the loader selects
// the best one for the processor. All give the same bits, as contraction is off and roots and quotients are
// exact.
#pragma once

// The sanitizers are not initialized yet when the loader chooses. Names of architectures would work as well,
// but GCC does not inline across them.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&                 \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define PROVEOUT_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default"), flatten))
#else
#define PROVEOUT_VECTOR_CLONES
#endif

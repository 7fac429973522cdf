/* wide.h -- loops for wider vectors than every x86-64 processor has.

   KW_WIDE before a static function has it compiled three times, for 128-bit vectors, for the
   256-bit ones of AVX2 and for the 512-bit ones of AVX-512; the program takes at its start
   what the processor has. All do the same operations in the same order, and none has a fused
   multiply-add, so the bits are the same too. Elsewhere the word is empty. No two functions
   with it have the same name: compilers make public symbols of it. */
#ifndef KW_WIDE_H
#define KW_WIDE_H

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__has_attribute)
#if __has_attribute(target_clones)
#define KW_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#endif

#ifndef KW_WIDE
#define KW_WIDE
#endif

#endif

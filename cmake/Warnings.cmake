# One interface target carries the warnings of every folder. GCC 12 warns of impossible sizes, overlaps and frees in its own
# std::string (PR 105329, 105651), the more where headers are precompiled; the sanitizers look for true ones.
add_library(gyromode_warnings INTERFACE)
target_compile_options(gyromode_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                   $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-free-nonheap-object>
                                                   $<$<BOOL:${GYROMODE_WERROR}>:-Werror>)

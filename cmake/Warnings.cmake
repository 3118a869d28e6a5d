# One interface target carries the warnings of every folder. GCC 12 warns of overlapping memcpy in its own std::string (PR 105651).
add_library(gyromode_warnings INTERFACE)
target_compile_options(gyromode_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                   $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
                                                   $<$<BOOL:${GYROMODE_WERROR}>:-Werror>)

# One interface target carries the warnings of every folder.
add_library(gyromode_warnings INTERFACE)
target_compile_options(gyromode_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                   $<$<BOOL:${GYROMODE_WERROR}>:-Werror>)

#pragma once

namespace gyromode::lapack {

/// Tells the C library to keep freed memory for the next matrix (glibc's M_MMAP_THRESHOLD and M_TRIM_THRESHOLD; nothing
/// elsewhere). By default memory of this size goes back to the system and is paid for again page by page, which costs a
/// solve of order 1000 a third of its time. The setting is the process's, so the library does not make it by itself: a
/// program calls this once, before the first solve, as gyromode does.
void keep_freed_memory();

}  // namespace gyromode::lapack

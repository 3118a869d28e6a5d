#pragma once

// LAPACKE with std::complex as its complex type: its own default is C99's, which C++ does not have.
#include <complex>
#define LAPACK_COMPLEX_CUSTOM
#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <lapacke.h>

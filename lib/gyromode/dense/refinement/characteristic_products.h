#pragma once

#include "gyromode/dense/impedance.h"

namespace gyromode::dense {

/// KX, GX and MX for every column of X (n × u, complex), in the order of the impedance: N(λ)X = KX + λGX + λ²MX. Empty for no columns.
struct CharacteristicProducts {
  ComplexMatrix k, g, m;
};
CharacteristicProducts characteristic_products(const Impedance& h, const ComplexMatrix& x);

}  // namespace gyromode::dense

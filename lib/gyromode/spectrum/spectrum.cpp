#include "gyromode/spectrum/spectrum.h"

#include <algorithm>

namespace gyromode {

void UnstableRoots::set(Index k, Complex root, const ComplexVector& x, const ComplexVector& y) {
  lambda[static_cast<std::size_t>(k)] = root;
  right.col(k) = x;
  left.col(k) = y;
}

void UnstableRoots::add(Complex root, const ComplexVector& x, const ComplexVector& y) {
  const Index k = count();
  lambda.push_back(root);
  right.conservativeResize(x.size(), k + 1);
  left.conservativeResize(y.size(), k + 1);
  right.col(k) = x;
  left.col(k) = y;
}

UnstableRoots UnstableRoots::chosen(const std::vector<Index>& kept) const {
  UnstableRoots part;
  for (const Index k : kept) part.lambda.push_back(lambda[static_cast<std::size_t>(k)]);
  part.right = right(Eigen::all, kept);
  part.left = left(Eigen::all, kept);
  return part;
}

void Spectrum::store_stiffness(const StiffnessInertia& d) {
  stiffness_negative = reduced_negative = impedance_negative = d.negative;
  stiffness_zero = d.zero;
  stiffness_margin = d.margin;
  rank_doubtful = d.doubtful;
  zero_shapes.resize(size(), 0);
}

ComplexVector Spectrum::shape(Index k) const {
  ComplexVector x = ComplexVector::Zero(size());
  if (split < 0) {
    x.real() = re.col(k);
    x.imag() = im.col(k);
  } else {
    x.head(split).real() = re.col(k);
    x.tail(size() - split).imag() = im.col(k);
  }
  return x;
}

Index Spectrum::divergent() const {
  return std::count_if(unstable.lambda.begin(), unstable.lambda.end(), [](const Complex& z) { return z.imag() == 0; });
}
Index Spectrum::fluttering() const { return unstable.count() - divergent(); }

void Spectrum::to_given_units(const Units& from) {
  const double rate = 1 / from.time;
  const Index p = split < 0 ? size() : split;
  const auto rows = [&](Index first, Index count) { return from.coordinate.segment(first, count).asDiagonal(); };
  omega *= rate;
  re = (rows(0, p) * re).eval();
  im = (split < 0 ? rows(0, p) : rows(p, size() - p)) * im.eval();
  zero_shapes = (rows(0, size()) * zero_shapes).eval();
  for (Complex& z : unstable.lambda) z *= rate;
  if (unstable.count() == 0) return;
  unstable.right = (rows(0, size()) * unstable.right).eval();
  unstable.left = (rows(0, size()) * unstable.left).eval();
}

}  // namespace gyromode

#include "gyromode/certificate/products.h"

namespace gyromode {

namespace {

// Xᴴ A X for a product AX.
double form_of(const Spectrum& s, const Matrix& re, const Matrix& im, Index i) {
  return s.re.col(i).dot(re.col(i)) + s.im.col(i).dot(im.col(i));
}

}  // namespace

Products products(const Impedance& h, const Spectrum& s) {
  Products p{h.products(s.re, s.im), {}};
  for (Index i = 0; i < s.omega.size(); ++i) {
    p.functionals.push_back({form_of(s, p.m_re, p.m_im, i), form_of(s, p.g_re, p.g_im, i),
                             h.second_order() ? form_of(s, p.k_re, p.k_im, i) : 0, h.second_order()});
  }
  return p;
}

void Products::reorder(const std::vector<Index>& order) {
  std::vector<Functional> sorted;
  for (const Index i : order) sorted.push_back(functional(i));
  functionals = std::move(sorted);
  for (Matrix* m : {&k_re, &k_im, &m_re, &m_im, &g_re, &g_im}) {
    if (m->cols() > 0) *m = Matrix((*m)(Eigen::all, order));
  }
}

}  // namespace gyromode

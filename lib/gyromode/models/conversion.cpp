#include "gyromode/models/conversion.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/constant_form.h"
#include "gyromode/dense/unitary_form.h"
#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

Matrix side_by_side(const Matrix& displacement, const Matrix& velocity) {
  Matrix u(displacement.rows(), displacement.cols() + velocity.cols());
  u << displacement, velocity;
  return u;
}

void add(const dense::ConstantForm& form, bool transformation, Conversion& to) {
  to.matrices.push_back({"W", form.w, Symmetry::symmetric, "eigenvalues ω². " + form.solver});
  if (!transformation) return;
  to.matrices.push_back({"U", side_by_side(form.displacement, form.velocity), Symmetry::general, "u = U (q, q') obeys u'' = -W u"});
  if (!form.bidiagonal) return;
  to.matrices.push_back({"D", *form.bidiagonal, Symmetry::general, "bidiagonal D, W = D'D"});
  to.matrices.push_back({"Q", *form.orthogonal, Symmetry::general, "orthogonal Q of order 2n, Z = Q T Q'"});
}

void add(const dense::UnitaryForm& form, bool transformation, Conversion& to) {
  to.matrices.push_back(
      {"W", form.w, Symmetry::general, "eigenvalues ω². Upper Hessenberg, from the Hamiltonian form by the unitary matrix Q1 + jQ2"});
  if (!transformation) return;
  to.matrices.push_back({"U", side_by_side(form.displacement, form.velocity), Symmetry::general, "v = U (q, q') obeys v'' = -W' v"});
  to.matrices.push_back({"Q1", form.q1, Symmetry::general, "real part of the unitary Q1 + jQ2"});
  to.matrices.push_back({"Q2", form.q2, Symmetry::general, "imaginary part of the unitary Q1 + jQ2"});
}

void add_realified(const System& system, bool transformation, Conversion& to) {
  try {
    add(dense::constant_form(system, analyse(system, HiddenSearch::always)), transformation, to);
  } catch (const NotApplicable& why) {
    to.remark += fmt::format("{}W is not symmetric, as ω² may be complex: {}. It is real, upper Hessenberg, by a unitary matrix",
                             to.remark.empty() ? "" : "; ", why.what());
    add(dense::unitary_form(system), transformation, to);
  }
}

// Where its matrices at the spin are the sums of its parts, as they are.
std::shared_ptr<const SpinFamily> family_of(const Model& model) {
  const System* system = model.body->second_order();
  if (!model.spin || !system || model.ignored || !system->repairs().empty() || !model.body->massless().empty()) return nullptr;
  try {
    return model.body->spin_source().family;
  } catch (const NotApplicable&) {
    return nullptr;
  }
}

}  // namespace

Conversion converted(const Model& model, bool realified, bool transformation) {
  Conversion all;
  for (const ModelKind::NamedMatrix& a : model.body->matrices()) {
    all.matrices.push_back({a.name, *a.matrix, a.skew ? Symmetry::skew_symmetric : Symmetry::symmetric, a.meaning});
  }
  const System* of = model.body->second_order();
  all.labels = of ? of->labels() : model.labels();
  if (all.matrices.empty()) throw NotApplicable("convert writes matrices, and this model is not made of any");
  if (const Labels massless = model.body->massless(); !massless.empty())
    all.remark =
        fmt::format("{} of {} coordinates have no mass: written are the condensed matrices of the others", massless.size(), model.size());
  if (!realified) {
    all.family = family_of(model);
    return all;
  }
  const System* second_order = model.body->second_order();
  if (!second_order) throw NotApplicable("--realified is for models of second order: eigenvalues of W are their ω²");
  add_realified(*second_order, transformation, all);
  return all;
}

}  // namespace gyromode

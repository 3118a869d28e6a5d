#pragma once

#include "gyromode/modes/components.h"
#include "gyromode/spectrum/counted_spectrum.h"

namespace gyromode {

/// The roots of a system of matrices, all of them, merged over its components; in rad per unit of time.
class MatrixSpectrum : public CountedSpectrum {
 public:
  explicit MatrixSpectrum(SolvedSystem solved);
  MatrixSpectrum(const MatrixSpectrum&) = delete;  // places refer to the components
  MatrixSpectrum& operator=(const MatrixSpectrum&) = delete;

  const std::vector<CountedRoot>* all_roots() const override { return &roots_; }
  RootRange roots(const Window& range, const Progress& progress = {}) const override;
  double above_all() const override;
  Index below(double omega) const override;
  Index missed_by_signs(const Window& range) const override;
  Index zero_roots() const override { return solved_.index_balance().zero; }
  Inertia inertia_at(double omega) const override { return solved_.inertia_at(omega); }
  Index negative_at_zero() const override { return at_zero_; }
  int direction() const override { return solved_.first_order ? -1 : 1; }
  IndexBalance balance() const override { return solved_.index_balance(); }
  std::string open_reason() const override;
  bool isolated() const override;
  void describe(ModesResult& result, bool with_shapes) const override;

  /// The oscillations ω > 0, all of them, with shapes and forms; zero modes, n × their number; and the roots off the
  /// axis.
  std::vector<Mode> oscillations() const;
  Matrix zero_shapes() const;
  UnstableRoots unstable() const;
  Index size() const { return solved_.size; }

 private:
  struct Place {
    const SolvedComponent* component = nullptr;
    Index position = 0;  // in its Spectrum; of a zero root among its zero shapes
  };
  void sort();
  Mode mode(std::size_t root, bool with_shape) const;
  UnstableMode growing(const SolvedComponent& c, Index k, bool with_shape) const;
  ComplexVector in_system(const SolvedComponent& c, const ComplexVector& part) const;
  ComplexVector shape_of(const SolvedComponent& c, const ComplexVector& part) const;

  SolvedSystem solved_;
  Index at_zero_ = 0;
  std::vector<CountedRoot> roots_;
  std::vector<Place> places_;  // of every root
};

}  // namespace gyromode

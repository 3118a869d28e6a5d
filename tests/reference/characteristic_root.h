#pragma once

#include <Eigen/Core>

#include <complex>

namespace gyromode::reference {

/// The distance in the complex plane, in 100 digits, between a root of λ²M + λG + K with M, G, K as given and the root
/// that it comes from of their (skew-)symmetric parts, both nearest to λ (Newton on det, from λ). n × n, n ≤ 12.
double moved_by_asymmetry(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, std::complex<double> lambda);

/// The distance of λ from the root of λ²M + λG + K nearest to it (Newton on det, from λ), in 100 digits; M may be
/// singular.
double distance_to_root(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, std::complex<double> lambda);

/// dω/dp, in 100 digits and rounded, of the simple root λ = jω of λ²M + λG + K nearest to it, where M, G, K change by
/// dM, dG, dK with p: the difference of the roots at p and p + 10⁻⁴⁰.
double slope_of_root(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, const Eigen::MatrixXd& dM,
                     const Eigen::MatrixXd& dG, const Eigen::MatrixXd& dK, double omega);

}  // namespace gyromode::reference

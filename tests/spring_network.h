// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_spring_network_h
#define tests_spring_network_h

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solver/constrained_minimization.h"

// Small minimisation problems without any mesh.

/// A convex energy of the elongation of a spring and its derivatives.
struct SpringLaw
{
  std::function<double(double)> energy, force, stiffness;
};



inline const SpringLaw linear = {[](const double e) { return 0.5 * e * e; },
                                 [](const double e) { return e; },
                                 [](const double) {
                                   return 1.;
                                 }};

inline const SpringLaw stiffening = {
  [](const double e) { return 0.5 * e * e + 0.25 * e * e * e * e; },
  [](const double e) { return e + e * e * e; },
  [](const double e) {
    return 1. + 3. * e * e;
  }};

/// Newton's method with full steps maps e to -e^3 when it looks for zero
/// force.
inline const SpringLaw softening = {
  [](const double e) { return std::sqrt(1. + e * e); },
  [](const double e) { return e / std::sqrt(1. + e * e); },
  [](const double e) {
    return std::pow(1. + e * e, -1.5);
  }};



/// Pi(u) = sum_k energy(c_k . u) - load . u with u <= bound. The rows c_k
/// of @p springs say which displacements elongate a spring.
class SpringNetwork : public ElastoPlastic::ConstrainedMinimization
{
public:
  SpringNetwork(const dealii::FullMatrix<double> &springs,
                const SpringLaw                  &law,
                const std::vector<double>        &load,
                const std::vector<double>        &bound,
                const std::vector<bool>          &active)
    : springs(springs)
    , law(law)
    , load(load)
    , bound(bound)
    , active(active)
    , tangent(load.size())
  {}

  void
  initialize_vector(Vector &vector) const override
  {
    vector.reinit(load.size());
  }

  bool
  has_energy() const override
  {
    return true;
  }

  std::string
  obstacle_to_convexity() const override
  {
    return has_energy() ? "" : "a material with recovering back stresses";
  }

  ElastoPlastic::Energy
  energy(const Vector &u) const override
  {
    double stored = 0, work = 0;
    for (unsigned int k = 0; k < springs.m(); ++k)
      stored += law.energy(elongation(k, u));
    for (unsigned int i = 0; i < load.size(); ++i)
      work += load[i] * u.local_element(i);
    return {stored - work, std::abs(stored) + std::abs(work)};
  }

  double
  force_scale() const override
  {
    double scale = 0;
    for (const double force : load)
      scale = std::max(scale, std::abs(force));
    return scale;
  }

  ElastoPlastic::Energy
  compute_residual(Vector &residual, const Vector &u) const override
  {
    for (unsigned int i = 0; i < load.size(); ++i)
      {
        residual.local_element(i) = load[i];
        for (unsigned int k = 0; k < springs.m(); ++k)
          residual.local_element(i) -=
            springs(k, i) * law.force(elongation(k, u));
      }
    return energy(u);
  }

  void
  linearize(const Vector &u) override
  {
    tangent = 0;
    for (unsigned int k = 0; k < springs.m(); ++k)
      for (unsigned int i = 0; i < load.size(); ++i)
        for (unsigned int j = 0; j < load.size(); ++j)
          tangent(i, j) +=
            springs(k, i) * law.stiffness(elongation(k, u)) * springs(k, j);
  }

  void
  step_taken(const Vector &, const Vector &) override
  {}

  void
  apply_tangent(Vector &result, const Vector &increment) const override
  {
    multiply(result, tangent, increment);
  }

  unsigned int
  solve_tangent(Vector &increment, const Vector &rhs, const double) override
  {
    dealii::FullMatrix<double> inverse = tangent;
    for (unsigned int i = 0; i < load.size(); ++i)
      for (unsigned int j = 0; j < load.size(); ++j)
        if (active[i] || active[j])
          inverse(i, j) = (i == j ? 1. : 0.);
    inverse.gauss_jordan();
    multiply(increment, inverse, rhs);
    return 1;
  }

  double
  slope_along(const Vector &residual, const Vector &increment) const override
  {
    return -(residual * increment);
  }

  void
  apply_inverse_diagonal(Vector &forces) const override
  {
    for (unsigned int i = 0; i < load.size(); ++i)
      forces.local_element(i) /= tangent(i, i);
  }

  bool
  update_active_set(const Vector &u, const Vector &residual) override
  {
    return set_active([&](const unsigned int i) {
      return active[i] ? residual.local_element(i) > 0 :
                         u.local_element(i) > bound[i];
    });
  }

  bool
  is_itself() const override
  {
    return true;
  }

  bool
  update_feasible_active_set(const Vector &u, const Vector &residual) override
  {
    return set_active([&](const unsigned int i) {
      return u.local_element(i) >= bound[i] && residual.local_element(i) > 0;
    });
  }

  std::uint64_t
  active_set_fingerprint() const override
  {
    std::uint64_t bits = 0;
    for (const bool is_active : active)
      bits = 2 * bits + is_active;
    return bits;
  }

  unsigned int
  n_active() const override
  {
    return std::count(active.begin(), active.end(), true);
  }

  void
  move_constrained(Vector &u) const override
  {
    for (unsigned int i = 0; i < load.size(); ++i)
      if (active[i])
        u.local_element(i) = bound[i];
  }

  void
  project(Vector &u) const override
  {
    for (unsigned int i = 0; i < load.size(); ++i)
      u.local_element(i) = std::min(u.local_element(i), bound[i]);
  }

  void
  return_to_bounds(Vector &) const override
  {}

  void
  reduce(Vector &residual) const override
  {
    for (unsigned int i = 0; i < load.size(); ++i)
      if (active[i])
        residual.local_element(i) = 0;
  }

  /// How far @p u is from a solution: penetration, tension, forces on free
  /// unknowns, work of contact forces over a gap.
  double
  optimality_error(const Vector &u)
  {
    Vector residual(load.size());
    compute_residual(residual, u);
    double error = 0;
    for (unsigned int i = 0; i < load.size(); ++i)
      {
        const double gap = bound[i] - u.local_element(i);
        const double force =
          (gap <= 1e-12 ? std::min(residual.local_element(i), 0.) :
                          std::abs(residual.local_element(i)));
        error = std::max({error, -gap, std::abs(force)});
      }
    return error;
  }

private:
  static void
  multiply(Vector                           &result,
           const dealii::FullMatrix<double> &matrix,
           const Vector                     &vector)
  {
    result = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
        result.local_element(i) += matrix(i, j) * vector.local_element(j);
  }

  double
  elongation(const unsigned int k, const Vector &u) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < load.size(); ++i)
      sum += springs(k, i) * u.local_element(i);
    return sum;
  }

  template <typename Predicate>
  bool
  set_active(const Predicate &is_active)
  {
    const std::vector<bool> old = active;
    for (unsigned int i = 0; i < load.size(); ++i)
      active[i] = is_active(i);
    return active != old;
  }

  const dealii::FullMatrix<double> springs;
  const SpringLaw                  law;
  const std::vector<double>        load, bound;
  std::vector<bool>                active;
  dealii::FullMatrix<double>       tangent;
};

/// The same, with an energy that nobody knows.
class SpringNetworkWithoutEnergy : public SpringNetwork
{
public:
  explicit SpringNetworkWithoutEnergy(const SpringNetwork &network)
    : SpringNetwork(network)
  {}

  bool
  has_energy() const override
  {
    return false;
  }

  ElastoPlastic::Energy
  energy(const Vector &) const override
  {
    return {};
  }
};

#endif

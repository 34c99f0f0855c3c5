#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/adjustment/joint/linearised.h"

namespace alidade {

// The leftover of a fit, and the trace of any further effect in it.
//
// Readings are whitened by their stated σ. Only the part of a vector that the fit cannot absorb counts. The
// fit absorbs the arc angle of each visit and the span of circles, slider zeros, pointing zeros and distance.
// Pointing zeros and distance are also observed, with their stated σ. With the projector P on the complement,
//
//   leftover  r = P (observed − model),        visible part of an effect with column c: P c.
//
// Source: elimination of nuisance parameters in the linear model, e.g. Koch, "Parameter estimation and
// hypothesis testing in linear models" (1999).
class Leftover {
 public:
  /// `inModel` are the terms that the fit estimates already. `noise` is the ratio of the actual to the stated
  /// scatter. The ratio increases the weight of prior knowledge, because the equations stay in units of the
  /// stated σ.
  explicit Leftover(Linearised equations, const std::vector<EstimatedTerm>& inModel = {}, double noise = 1);

  /// Number of readings plus one entry for each observation of a prior and each condition.
  Eigen::Index rows() const { return m_residual.size(); }
  Eigen::Index readings() const { return m_along.size(); }
  const LinearReading& reading(Eigen::Index i) const {
    return m_equations.readings[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd& residual() const { return m_residual; }
  double chiSquare() const { return m_residual.squaredNorm(); }
  /// The equations that the leftover was computed from.
  const Linearised& equations() const { return m_equations; }
  int degreesOfFreedom() const { return m_degreesOfFreedom; }

  /// Returns the part of `columns` (`rows()` or `readings()` long) that the fit cannot absorb.
  Eigen::MatrixXd visible(const Eigen::MatrixXd& columns) const;
  /// The observations, and `columns` (`rows()` or `readings()` long), after elimination of arc angles only.
  const Eigen::VectorXd& observed() const { return m_observed; }
  Eigen::MatrixXd outsideArcAngles(const Eigen::MatrixXd& columns) const;
  /// Orthonormal basis of what the fit absorbs, orthogonal to the arc angles. If the fit absorbs nothing, the
  /// basis is one column of zeros: Eigen fails on matrices without columns.
  const Eigen::MatrixXd& basis() const { return m_basis; }
  Eigen::Index visits() const { return static_cast<Eigen::Index>(m_endOfVisit.size()); }
  /// A run of readings from `first` to before `end`.
  struct Run {
    Eigen::Index first, end;
    Eigen::Index length() const { return end - first; }
  };
  Run readingsOf(Eigen::Index visit) const {
    const auto v = static_cast<std::size_t>(visit);
    return {v == 0 ? 0 : m_endOfVisit[v - 1], m_endOfVisit[v]};
  }
  /// Entries of the basis for one reading.
  auto basisOfRow(Eigen::Index row) const { return m_basis.row(row).transpose(); }
  /// Redundancy of a reading: |P e|² for an error e of 1σ of this reading alone.
  double redundancy(Eigen::Index reading) const { return m_redundancy[reading]; }
  /// ∂reading/∂term, whitened, before projection, `readings()` long.
  Eigen::VectorXd column(ErrorTerm term) const;
  /// For each term, the inner product of its whitened ∂reading/∂term with `visible`, which is `rows()` or
  /// `readings()` long. 0 for terms without derivatives in the equations.
  Eigen::VectorXd productsOfTerms(const Eigen::VectorXd& visible) const;
  /// ∂reading/∂unknown, whitened, for the unknown of this kind of each reading's arc; 0 if the arc has none.
  Eigen::VectorXd column(Unknown::Kind kind) const;

 private:
  Linearised m_equations;
  Eigen::VectorXd m_along;                 ///< derivative of each reading by its arc angle, normalised
  std::vector<Eigen::Index> m_endOfVisit;  ///< index after the last reading of each visit
  Eigen::VectorXd m_observed, m_residual, m_redundancy;
  Eigen::MatrixXd m_basis;
  int m_degreesOfFreedom = 0;

  void eliminateArcAngles(Eigen::MatrixXd& columns) const;
  void markVisits();
  /// Returns the columns that the fit absorbs; fills `m_observed` with the observations.
  Eigen::MatrixXd layOutUnknowns(const std::vector<EstimatedTerm>& inModel, double noise);
};

/// Returns the variance of a number due to the scatter of the readings, in the number's unit squared.
/// `perReading` is the change of the number per σ of each reading. Zeros are excluded, because they do not
/// scatter like readings.
double varianceOfReadings(const Leftover& leftover, const Eigen::VectorXd& perReading);

}  // namespace alidade

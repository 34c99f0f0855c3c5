#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/adjustment/joint/linearised.h"

namespace alidade {

// What a fit leaves over, and what any further effect would leave over.
//
// Readings are whitened by their stated σ. Of every vector over the readings only the part counts that the
// fit cannot take up: outside the arc angle of each visit and the span of the circles, slider zeros, pointing
// zeros and distance (the last two at their stated σ, as observations of zero). With P the projector on it,
//
//   leftover  r = P (observed − model),        visible part of an effect with column c: P c.
//
// Source: elimination of nuisance parameters in the linear model, e.g. Koch, "Parameter estimation and
// hypothesis testing in linear models" (1999).
class Leftover {
 public:
  /// `inModel` are terms the fit estimates already. `noise`: how much more than stated the readings are known
  /// to scatter; what is known beforehand weighs more by it, in the readings' stated σ.
  explicit Leftover(Linearised equations, const std::vector<EstimatedTerm>& inModel = {}, double noise = 1);

  /// Readings, then an entry for each observation of a prior and each condition.
  Eigen::Index rows() const { return m_residual.size(); }
  Eigen::Index readings() const { return m_along.size(); }
  const LinearReading& reading(Eigen::Index i) const {
    return m_equations.readings[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd& residual() const { return m_residual; }
  /// Its products with the terms, as `productsOfTerms` has them.
  const Eigen::VectorXd& residualByTerms() const { return m_residualByTerms; }
  double chiSquare() const { return m_residual.squaredNorm(); }
  /// The equations it was made of.
  const Linearised& equations() const { return m_equations; }
  int degreesOfFreedom() const { return m_degreesOfFreedom; }

  /// The part of `columns` (rows() or readings() long) that the fit cannot take up.
  Eigen::MatrixXd visible(const Eigen::MatrixXd& columns) const;
  /// What was observed, and `columns`: rows() long, outside the arc angles only.
  const Eigen::VectorXd& observed() const { return m_observed; }
  Eigen::MatrixXd outsideArcAngles(const Eigen::MatrixXd& columns) const;
  /// Orthonormal, of what the fit takes up, at right angles to the arc angles. A column of zeros where that
  /// is nothing: Eigen divides by, or points into, what has no columns.
  const Eigen::MatrixXd& basis() const { return m_basis; }
  Eigen::Index visits() const { return static_cast<Eigen::Index>(m_endOfVisit.size()); }
  /// One after the other, from `first` to before `end`.
  struct Run {
    Eigen::Index first, end;
    Eigen::Index length() const { return end - first; }
  };
  Run readingsOf(Eigen::Index visit) const {
    const auto v = static_cast<std::size_t>(visit);
    return {v == 0 ? 0 : m_endOfVisit[v - 1], m_endOfVisit[v]};
  }
  /// The basis' entries for one reading.
  auto basisOfRow(Eigen::Index row) const { return m_basis.row(row).transpose(); }
  /// |P e|² for an error e of one reading, 1σ: its redundancy.
  double redundancy(Eigen::Index reading) const { return m_redundancy[reading]; }
  /// ∂reading/∂term, whitened, not projected, readings() long.
  Eigen::VectorXd column(ErrorTerm term) const;
  /// Inner products of ∂reading/∂term of every term with a visible vector, rows() or readings() long; 0 for
  /// terms the equations were not differentiated by.
  Eigen::VectorXd productsOfTerms(const Eigen::VectorXd& visible) const;
  /// ∂reading/∂unknown of the readings' own arc; 0 where the arc has no such unknown.
  Eigen::VectorXd column(Unknown::Kind kind) const;

 private:
  Linearised m_equations;
  Eigen::VectorXd m_along;                 ///< of each reading
  std::vector<Eigen::Index> m_endOfVisit;  ///< behind the last reading of each visit
  Eigen::VectorXd m_observed, m_residual, m_residualByTerms, m_redundancy;
  Eigen::MatrixXd m_basis;
  int m_degreesOfFreedom = 0;

  void eliminateArcAngles(Eigen::MatrixXd& columns) const;
  void markVisits();
  /// What the fit takes up; fills m_observed with what was observed.
  Eigen::MatrixXd layOutUnknowns(const std::vector<EstimatedTerm>& inModel, double noise);
};

/// What scatters as the readings do brings to a number that moves by so much for each σ of a reading: zeros
/// do not scatter so. In the number's unit squared.
double varianceOfReadings(const Leftover& leftover, const Eigen::VectorXd& perReading);

}  // namespace alidade

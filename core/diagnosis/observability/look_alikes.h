#pragma once

#include <Eigen/Core>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/result/look_alike.h"

namespace alidade {

// Effects with the same trace in these readings.

/// The trace of an effect in the readings: a visible vector. The leftover must outlive the trace.
class Trace {
 public:
  Trace(const Leftover& leftover, Eigen::VectorXd visible);

  double length() const { return m_visible.norm(); }
  /// Returns the distance to the nearest trace of an effect, σ of the readings. Two effects at a distance of
  /// d are confused with probability Φ(−d/2).
  double differenceFrom(const Component& effect) const;
  /// Compares the trace with the nearest trace of an effect.
  LookAlike compared(const Component& effect) const;

 private:
  Eigen::VectorXd m_visible;
  SharedProducts m_products;
};

/// Returns the distance from a trace of squared length `square` to the nearest trace of a bent effect. `gram`
/// belongs to the effect's columns and second derivatives, `right` are their products with the trace.
double differenceFromBent(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, double square);

}  // namespace alidade

#pragma once

#include <Eigen/Core>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/result/look_alike.h"

namespace alidade {

// Which effects leave the same trace in these very readings.

/// What something leaves in the readings, a visible part. The leftover has to live as long.
class Trace {
 public:
  Trace(const Leftover& leftover, Eigen::VectorXd visible);

  double length() const { return m_visible.norm(); }
  /// How far the nearest trace that an effect can leave is, in σ of the readings: two effects this far apart
  /// are taken for one another in Φ(−d/2) of the cases.
  double differenceFrom(const Component& effect) const;
  /// How like the effect's nearest trace is.
  LookAlike compared(const Component& effect) const;

 private:
  Eigen::VectorXd m_visible;
  SharedProducts m_products;
};

/// How far the nearest trace of an effect that bends is from one of the squared length `square`: `gram` of
/// its columns and second derivatives, `right` their products with the trace.
double differenceFromBent(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, double square);

/// Mistaken for one another in 7 % of the cases: no answer to rely on.
inline constexpr double hardlyDifferent = 3.0;
/// Mistaken in 2 %: told apart, where the readings agree.
inline constexpr double clearlyDifferent = 4.2;

}  // namespace alidade

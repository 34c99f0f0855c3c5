#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"

namespace alidade {

// Checks whether an arc's readings determine a circle.

/// Counts places that differ by more than the stated noise, up to the three that determine a circle.
class DifferentPlaces {
 public:
  static constexpr std::size_t needed = 3;

  explicit DifferentPlaces(const Measurement& measurement);

  /// Counts the place if it differs from every counted place. Returns whether `needed` places are counted.
  bool areEnoughWith(const PlanePoint<double>& place);
  std::size_t count() const { return m_places.size(); }

 private:
  double m_resolution;  ///< mm
  boost::container::static_vector<PlanePoint<double>, needed> m_places;
};

/// Returns the fault if fewer than three sighted places differ by more than the stated noise (5 σ): they
/// determine no circle. Needs no fit.
std::optional<ArcFault> tooFewPlaces(const Measurement& measurement,
                                     const std::vector<PlanePoint<double>>& places);

/// Returns the fault if the stated noise alone makes the radius of the fitted circle uncertain by more than a
/// third of itself (1σ). The noise then hides the sagitta, and the linear theory behind every σ is invalid.
std::optional<ArcFault> radiusUndetermined(const ArcFit& fit);

/// The angle the sighted places span, seen from the fitted centre, in (0, 2π].
Angle arcSpan(const ArcFit& fit);

}  // namespace alidade

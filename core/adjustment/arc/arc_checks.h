#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"

namespace alidade {

// Whether an arc's readings can carry a circle.

/// Counts places that differ by more than the stated noise, up to the three that a circle takes.
class DifferentPlaces {
 public:
  static constexpr std::size_t needed = 3;

  explicit DifferentPlaces(const Measurement& measurement);

  /// With this one, too?
  bool areEnoughWith(const PlanePoint<double>& place);
  std::size_t count() const { return m_places.size(); }

 private:
  double m_resolution;  ///< mm
  boost::container::static_vector<PlanePoint<double>, needed> m_places;
};

/// Why the places sighted fix no circle before any fit: fewer than three of them differ by more than the
/// stated noise.
std::optional<ArcFault> tooFewPlaces(const Measurement& measurement,
                                     const std::vector<PlanePoint<double>>& places);

/// Why the fitted circle is none: from the stated noise alone its radius is uncertain by more than a third of
/// itself (1σ), so the sagitta drowns in the noise and the linear theory behind every σ no longer holds.
std::optional<ArcFault> radiusUndetermined(const ArcFit& fit);

/// The angle the sighted places span, seen from the fitted centre, in (0, 2π].
Angle arcSpan(const ArcFit& fit);

}  // namespace alidade

#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/own_effects.h"

namespace alidade {

/// What a line of an own effect does to its carrier at plausible sizes.
struct OwnCurve {
  FormCarrier carrier = FormCarrier::Radial;
  std::string_view variable;  ///< of `formulaVariables`, that of all lines; empty: they have none or several
  /// The variable (angles in degrees) and the displacement, mm or arcseconds. Without a single variable the
  /// first is the number of the sighting, from 1. In order of the first.
  std::vector<std::array<double, 2>> points = {};
};

/// A curve for each line of the formula, within the range of the session's sightings. Variables that have a
/// few values, such as the leg, have a point for each. What has no finite value is left out.
std::vector<OwnCurve> curvesOf(const OwnEntry& entry, const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade

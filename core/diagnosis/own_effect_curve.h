#pragma once

#include <array>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/own_effects.h"
#include "core/terms/formula_text.h"

namespace alidade {

/// What a line of an own effect does to its carrier at plausible sizes.
struct OwnCurve {
  FormCarrier carrier = FormCarrier::Radial;
  const FormulaVariable* variable = nullptr;  ///< that of all lines; null: they have none or several
  /// The variable (an angle in degrees) and the displacement, mm or arcseconds. Without a single variable the
  /// first is the number of the sighting in the session, from 1. In order of the first.
  std::vector<std::array<double, 2>> points = {};
};

/// A curve for each line of the formula, within the range of the session's sightings. A counted variable has
/// a point for each value. Of very many sightings some stand for all. What has no finite value is left out.
std::vector<OwnCurve> curvesOf(const OwnEntry& entry, const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade

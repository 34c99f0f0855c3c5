#pragma once

#include <array>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/own_effects.h"
#include "core/terms/formula_text.h"

namespace alidade {

/// The displacement of a carrier by one line of an own effect, at plausible sizes.
struct OwnCurve {
  FormCarrier carrier = FormCarrier::Radial;
  const FormulaVariable* variable = nullptr;  ///< the only variable of all lines; null: none or several
  /// The variable (an angle in degrees) and the displacement, mm or arcseconds, sorted by the variable.
  /// Without a single variable, the number of the sighting in the session, from 1, replaces the variable.
  std::vector<std::array<double, 2>> points = {};
};

/// A curve for each line of the formula, within the range of the session's sightings. A counted variable has
/// a point for each value. If there are very many sightings, only some have a point. Values that are not
/// finite are omitted.
std::vector<OwnCurve> curvesOf(const OwnEntry& entry, const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade

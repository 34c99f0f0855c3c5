#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/answers/fit_answer.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

/// Returns a table of the results, one quantity in each row: Δd, measured and fit only; Δz and the distance
/// from the axis, if measured; |O1 − O2|/2; of each arc centre, radius, number of sightings, rms, reduced χ²
/// and redundancy. Lengths are in mm, y up, rms in arcseconds, as the unit of the row states; counts and
/// ratios have none. A cell is empty if its number is not finite.
std::string resultsCsv(const FitAnswer& answer);

/// Returns a table of the contributions to every uncertainty. `quantity` is `intersection_as_measured` (with
/// every plausible effect), `intersection_of_fit` (readings, zeros and distance only), or `x`, `y` and
/// `radius` of each arc. `share` is the share of the variance of that quantity. `found` is null without a
/// diagnosis. The first quantity is then absent; the second is absent without an intersection.
std::string budgetCsv(const SessionFit& fit, const Diagnosis* found);

/// Returns a table with a row for each reading of the fit, slider readings included, in the order in which
/// they were taken. It states where the reading was taken and its residual (observed minus adjusted, right
/// and up positive). It also states σ and how well other readings check it. Column names contain the units; a
/// cell is empty if its number is not finite. `fit` is that of the measurement.
std::string residualsCsv(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade

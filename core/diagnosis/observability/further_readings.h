#pragma once

#include <functional>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Readings that could be taken in addition to those of a session.

/// Measures for more readings, with the resulting readings of one or several set-ups.
struct FurtherReadings {
  std::vector<Measure> measures;
  std::vector<Measurement> sets;
  bool includesSession = false;  ///< the first set is the session itself, with error-free readings
  bool goesOn = false;  ///< the only set is the session with more readings at its end; its rows keep their
                        ///< numbers
};

/// Returns a term of the model as error-free readings show it: at its fitted size if the effect is bent,
/// since its derivatives depend on the size, else at 0.
EstimatedTerm asPlanned(EstimatedTerm term, const GapModel& model);

/// Returns the session as planned, with error-free readings that contain only the model's bent effects.
Measurement readWithoutError(const GapModel& model);

/// Calls a function for the session with each single measure: other face, way back, slider, shifted circle,
/// second stand-off, more of the arc, a repeated position. Measures that the session has already are skipped.
void eachFurtherReadings(const GapModel& model, const std::function<void(const FurtherReadings&)>& take);

/// Calls a function for the session with each combination of measures: two or all of other face, way back and
/// slider; both positions repeated.
void eachCombination(const GapModel& model, const std::function<void(const FurtherReadings&)>& take);

/// Linearises planned readings. The terms of the model are estimated (`asPlanned`); derivatives are by these
/// terms and by `terms`. Passes pieces to `take`, like `linearise`.
void linearisePlan(const GapModel& model, const Measurement& set, const std::vector<ErrorTerm>& terms,
                   const std::function<void(const Linearised& piece)>& take);

}  // namespace alidade

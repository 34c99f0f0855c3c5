#pragma once

#include <functional>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Readings that could be taken besides those of a session.

/// A way to read more, and what would then have been read: one set-up or several.
struct FurtherReadings {
  std::vector<Measure> measures;
  std::vector<Measurement> sets;
  bool besideSession = false;  ///< the first set is the session itself, read without error
  bool goesOn = false;  ///< the only set is the session with more behind it, its rows as numbered there
};

/// The session as it was planned: every reading without error.
Measurement readWithoutError(const GapModel& model);

/// The same session with the other face, the way back, the slider, a shifted circle, a second stand-off, more
/// of the arc or one of its positions once more read along, one after the other; what it has already is not
/// offered.
void eachFurtherReadings(const GapModel& model, const std::function<void(const FurtherReadings&)>& take);

/// With any two of the other face, the way back and the slider, with all three, and with both positions once
/// more.
void eachCombination(const GapModel& model, const std::function<void(const FurtherReadings&)>& take);

/// The equations of a set as planned; effects of the model are not there, but estimated along. With
/// derivatives by them and by `terms`. In pieces, as `linearise` hands them on.
void linearisePlan(const GapModel& model, const Measurement& set, const std::vector<ErrorTerm>& terms,
                   const std::function<void(const Linearised& piece)>& take);

}  // namespace alidade

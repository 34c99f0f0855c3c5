#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: a few readings were misread or mistyped, by anything from some noise to many degrees, and
// any reading may be affected. Each is modelled as shifted by an unknown amount, and the shift is tested. A
// majority of rows determines the start (robust_start.h). From there, readings are named as misread or
// cleared again, until every named reading is significant and no other is. The fit is repeated with the
// shifts subtracted, so that linear theory holds for shifts of any size.
//
// The scale of the noise is estimated from the readings neither named nor tested, so the test value is
// Student's t (`ReadingTest`). Source of the test: W. Baarda, "A testing procedure for use in geodetic
// networks" (1968); A. J. Pope, "The statistics of residuals and the detection of outliers" (1976).
//
// Undetectable: an error along the arc in a visit without a second face or slider reading, because the slider
// may have been there. In such a visit, errors of both circles leave the same residual and are
// indistinguishable; the other circle is then among `rivals`.

struct GrossError {
  ReadingRef cell;
  /// The reading minus the prediction of all sound readings, reduced: right and up positive, the slider as
  /// read.
  Angle size;
  Angle sigma;             ///< of the size, scaled by the scatter of the sound readings
  double studentised = 0;  ///< t of the size
  /// Readings of the same visit whose shift explains the misfit nearly as well: χ² is larger by less than 9,
  /// in units of the noise.
  std::vector<ReadingRef> rivals;
};

struct GrossErrorOptions {
  double risk = ReadingTest::usualRisk;  ///< of naming any reading of a sound session, in (0, 1)
  JointFitOptions fit = {};  ///< error terms to estimate, excluded readings, …, as for the joint fit
  std::size_t most = 12;     ///< maximum number of readings named
  /// The fit of all readings with these options, if available; may be null.
  const JointFit* known = nullptr;
};

struct GrossErrorSearch {
  std::vector<GrossError> grossErrors;  ///< the most certain first
  JointFit fit;                         ///< of all readings, with the shifts of the misread ones subtracted
  std::vector<ReadingRef> leftOut;      ///< both circles of the omitted sightings, named or not
  double noiseFactor = 1;               ///< scatter of the sound readings divided by the stated σ
  int degreesOfFreedom = 0;             ///< of `noiseFactor`; 0 or less: tests were impossible
  double criticalValue = 0;             ///< |t| from which a reading is named; 0 without a test
};

/// Every arc must determine a circle (`fitArc` succeeds). Soon returns an empty result after a stop request.
GrossErrorSearch searchGrossErrors(const Measurement& measurement, const GrossErrorOptions& options = {},
                                   const std::stop_token& stop = {});

/// Subtracts `size` from a reading of the measurement.
void shiftReading(Measurement& measurement, const ReadingRef& cell, Angle size);

}  // namespace alidade

#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: a few readings were misread or mistyped, by anything from some noise to many degrees, and no
// reading is known to be sound. Each is taken as shifted by an unknown amount, and the shift is tested: from
// a start that a majority of rows decides (robust_start.h), readings are added to those called misread and
// taken off again until every one called is significant and no other is. The fit is made anew with the shifts
// taken off, so that linear theory holds however large they are.
//
// The noise is not taken as stated: the scale is that of the readings neither called nor tested, so the test
// value is Student's t (`ReadingTest`). Source of the test: W. Baarda, "A testing procedure for use in
// geodetic networks" (1968); A. J. Pope, "The statistics of residuals and the detection of outliers" (1976).
//
// What cannot be found: an error along the arc in a visit without a second face or slider reading, because
// the slider could have stood there. And in such a visit both circles' errors leave the same residual, so the
// circle cannot be told; it is then named among `rivals`.

struct GrossError {
  ReadingRef cell;
  /// Read minus what all sound readings say, as reduced: right and up positive, the slider as read.
  Angle size;
  Angle sigma;             ///< of the size, scaled as the sound readings scatter
  double studentised = 0;  ///< t of the size
  /// Readings of the same visit that would explain the misfit as well as this one (χ² within 9 of it, in
  /// units of the noise).
  std::vector<ReadingRef> rivals;
};

struct GrossErrorOptions {
  double risk = ReadingTest::usualRisk;  ///< of naming any reading of a sound session, in (0, 1)
  JointFitOptions fit = {};  ///< terms estimated along, readings left out, … as for the joint fit
  std::size_t most = 12;     ///< at most so many are named
  /// The fit of all readings with these options, where it is known already; may be null.
  const JointFit* known = nullptr;
};

struct GrossErrorSearch {
  std::vector<GrossError> grossErrors;  ///< the most certain first
  JointFit fit;                         ///< of all readings, the shifts taken off those misread
  std::vector<ReadingRef> leftOut;      ///< both circles of the sightings left out, named or not
  double noiseFactor = 1;               ///< scatter of the sound readings over the stated one
  int degreesOfFreedom = 0;             ///< behind it; 0 or less: nothing could be tested
  double criticalValue = 0;             ///< |t| from which a reading is called; 0 where nothing was tested
};

/// Every arc must fix a circle (`fitArc` succeeds). Asked to stop, it soon returns nothing.
GrossErrorSearch searchGrossErrors(const Measurement& measurement, const GrossErrorOptions& options = {},
                                   const std::stop_token& stop = {});

/// The measurement with `size` taken off a reading.
void shiftReading(Measurement& measurement, const ReadingRef& cell, Angle size);

}  // namespace alidade

#pragma once

#include <stop_token>
#include <vector>

#include "core/adjustment/gross_errors/corrections.h"
#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/angle.h"
#include "core/base/problem.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// The probable intention: changes of the typed text that make the reading agree with all others.
struct Proposal {
  EntryError error = EntryError::OneDigitWrong;
  std::vector<CellChange> changes;  ///< made together; never empty
  Angle residual;                   ///< residual of the suspect reading afterwards, as read
  double share = 0;                 ///< probability among the corrections tried, 0…1
};

/// A reading that disagrees with the others: it was misread or mistyped, or its target was displaced.
struct Suspect {
  Place where;  ///< position, reading and field of the cell
  int axisDeg = 0, point = 0, round = 1, face = 1;
  int repeat = 1;  ///< as `ArcMeasurement::repeat`
  ReadingKind kind = ReadingKind::Horizontal;
  /// The typed value minus the value predicted by the other readings, as read on the circle. Half a turn for
  /// a wrong face; NaN if the typed text is not an angle.
  Angle size;
  double studentised = 0;           ///< t of the residual; 0 if the row could not be used in the fit
  std::vector<Place> rivals;        ///< cells that could be at fault instead
  std::vector<Proposal> proposals;  ///< the most probable first; may be empty
  /// A correction was found but is not proposed, since more than one reading may be wrong.
  bool isMasked = false;
};

struct SuspectOptions {
  double risk = ReadingTest::usualRisk;  ///< of naming any reading of a sound session, in (0, 1)
};

/// The readings of a fitted session that look misread, the most certain first; the session itself stays
/// unchanged. Rows that could not be used are also examined, and named if an entry error explains them.
/// `measurement` is that of `session`, `fit` its fit. `searchGrossErrors` finds these readings. If an entry
/// error makes the visit agree with all others, this error decides which cell is at fault. After a stop
/// request the function soon returns the suspects found so far.
std::vector<Suspect> findSuspects(const Session& session, const Measurement& measurement,
                                  const SessionFit& fit, const SuspectOptions& options = {},
                                  const std::stop_token& stop = {});

}  // namespace alidade

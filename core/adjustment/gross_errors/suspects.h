#pragma once

#include <stop_token>
#include <vector>

#include "core/adjustment/gross_errors/corrections.h"
#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/angle.h"
#include "core/base/place.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// What was probably meant: changes to what was typed that make the reading agree with all others.
struct Proposal {
  EntrySlip slip = EntrySlip::OneDigitWrong;
  std::vector<CellChange> changes;  ///< all of them together; never empty
  Angle residual;                   ///< what the suspect reading leaves over afterwards, as read
  double share = 0;                 ///< probability among the corrections tried, 0…1
};

/// A reading that does not go with the others: misread, mistyped, or its target not where it should be.
struct Suspect {
  Place where;  ///< position, reading and field of the cell
  int axisDeg = 0, point = 0, round = 1, face = 1;
  int time = 1;  ///< as `ArcMeasurement::time`
  ReadingKind kind = ReadingKind::Horizontal;
  /// As typed minus what the other readings say it should be, as read on the circle; half a turn for a wrong
  /// face, NaN where what was typed is no angle.
  Angle size;
  double studentised = 0;  ///< t of the misfit; 0 where the row could not be used and took no part in the fit
  std::vector<Place> rivals;        ///< cells that could be at fault instead
  std::vector<Proposal> proposals;  ///< the most probable first; may be empty
  /// A slip would explain it, and another one besides may hide what was meant: then nothing is proposed.
  bool isMasked = false;
};

struct SuspectOptions {
  double risk = ReadingTest::usualRisk;  ///< of naming any reading of a sound session, in (0, 1)
};

/// The readings of a fitted session that look misread, the most certain first; nothing is changed or left out
/// because of it. Rows that could not be used are looked at, too, and named where a slip explains them.
/// `measurement` is what `session` means, `fit` its fit. Which readings these are says
/// `searchGrossErrors`; the slip that makes its visit agree with all others decides which cell is at
/// fault, where one does. Asked to stop, it returns early with what it has found.
std::vector<Suspect> findSuspects(const Session& session, const Measurement& measurement,
                                  const SessionFit& fit, const SuspectOptions& options = {},
                                  const std::stop_token& stop = {});

}  // namespace alidade

#pragma once

#include "core/evaluation/gap.h"
#include "core/statement/statement.h"

namespace alidade {

// The statements on a gap, each in a file of its own. All except `gapKnown` need a diagnosis. U is at the
// coverage of the measurement. A statement with nothing to state is empty.

/// Why the gap has no diagnosis, in sentences.
std::string reasonForNone(const Gap& gap);

/// The headline and the sentences of the diagnosis, without a table.
Statement gapVerdict(const Gap& gap);

/// The causes, the forms or the pattern, and the effects of the model: size ± U, probability, what each
/// closes or by how much it shrinks the residuals, and its look-alikes. The id of a row is that of the cause;
/// empty for forms, patterns and details.
Statement gapCauses(const Gap& gap);

/// Sentences on each form: the range in which the model is valid without the form, and how much the form
/// reduces the gap. No table.
Statement gapForms(const Gap& gap);

/// The residuals and Δd in each stage from the bare model to Δd, measured.
Statement gapStages(const Gap& gap);

/// A sentence on each division of the readings that has several parts, by frame, position, circle, …: the
/// shares of the parts in the gap, from 1 % on. `where`: of a session or of a series. No table.
Statement gapWhere(const std::vector<GapShare>& where);

/// The closures with the session's own model, and with the causes added; `isNotable` marks failing closures.
Statement gapClosures(const Gap& gap);

/// The size of each effect that would explain Δd − reference.
Statement gapRequired(const Gap& gap);

/// The undetectable effects that may move Δd noticeably.
Statement gapUndetectable(const Gap& gap);

/// What to measure next, and attainable U (next_measures.h).
Statement gapAdvice(const Gap& gap);

/// The known sizes, and their comparison with these readings.
Statement gapKnown(const Gap& gap);

}  // namespace alidade

#pragma once

#include "core/adjustment/result/session_fit.h"
#include "core/statement/statement.h"

namespace alidade {

/// The arcs of both axis angles: centre and radius with u, scatter of the residuals, and redundancy. Lengths
/// in mm, angles in arcseconds. Repeats of one axis angle share a row, with the residuals of each in a part
/// below. The sentence gives |O1 − O2|/2, if there are both arcs.
Statement arcTable(const SessionFit& fit);

/// The arcs of the published method as it prints them, each the mean over the positions at its axis, and Δd.
Statement publishedTable(const PublishedSessionFit& fit);

/// The effects of the session's model, estimated along with the arcs. Without rows if the model has none.
Statement effectTable(const std::vector<EffectEstimate>& effects);

}  // namespace alidade

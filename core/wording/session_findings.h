#pragma once

#include "core/adjustment/result/fit_finding.h"
#include "core/wording/words.h"

namespace alidade {

Words wordsOf(const session_finding::ArcMissing& finding);
Words wordsOf(const session_finding::Undetermined& finding);
Words wordsOf(const session_finding::PositionMissing& finding);
Words wordsOf(const session_finding::RadiiDiffer& finding);
Words wordsOf(const session_finding::CentresDiffer& finding);
Words wordsOf(const session_finding::KnownRadiusContradicted& finding);
Words wordsOf(const session_finding::UnknownEffect& finding);
Words wordsOf(const session_finding::KnownOfNothing& finding);
Words wordsOf(const session_finding::CorrectionsDiffer& finding);
Words wordsOf(const session_finding::TiltsUnused& finding);
Words wordsOf(const session_finding::AxisMoved& finding);
Words wordsOf(const session_finding::CompensatorOff& finding);
Words wordsOf(const session_finding::PlanarRelation& finding);

}  // namespace alidade

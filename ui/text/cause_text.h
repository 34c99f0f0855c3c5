#pragma once

#include <QString>

#include "ui/jobs/gap.h"

namespace alidade::ui {

/// Anything a diagnosis may name, as it stands within a sentence: "trunnion tilt", "a jump of the
/// orientation", "misread values", "noise larger than stated".
QString causeName(const std::string& id);
/// The same for sentences of the core.
std::string causeNameInCore(const std::string& id);
/// With a capital.
QString causeTitle(const std::string& id);
/// "a, b or c"; `last` parts the last two, with its blanks: " or ".
QString causeNames(const std::vector<std::string>& ids, const QString& last);

/// "sag −0.298 mm (u 0.009)"; just the number where the name says no more than the effect's.
QString parameterText(const Cause& cause, const CauseParameter& parameter);

/// "0°, point 11, horizontal, off by 29.0″", with round and face where they are not 1.
QString deviationText(const ReadingDeviation& reading);
Place placeOf(const ReadingDeviation& reading);

/// 1σ of what is plausible of an effect's first number, empty for what is none of the catalogue.
QString plausibleText(const std::string& id);

/// The verdict in a few words: "One cause: collimation".
QString gapHeadline(const Diagnosis& diagnosis);
/// The verdict in whole sentences.
QString diagnosisText(const Diagnosis& diagnosis);
/// The same with what the session's model accounts for already.
QString gapSentence(const Gap& gap);

/// "plane tilt ± 0.12 mm; gravity sag ± 0.05 mm": what a plausible size of each moves Δd by.
QString unseenText(const std::vector<UnseenEffect>& effects);
/// What may move Δd by more than U, unseen, the worst three by name; empty where nothing may.
QString unseenBeyondUText(const Gap& gap);

/// What is in the model at this stage, one of the gap's: "as modelled", "in the model: gravity sag", "+
/// collimation".
QString stageText(const Gap& gap, const GapStage& stage);

/// "−2.1675 ± 0.0421 mm", "—" where there is none.
QString estimateText(const std::optional<IntersectionEstimate>& estimate);

/// What U could be with more read or known (`attainableSentence`); may be empty.
QString attainableText(const Gap& gap);

}  // namespace alidade::ui

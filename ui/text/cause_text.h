#pragma once

#include <QString>

#include "core/evaluation/gap.h"

namespace alidade::ui {

/// The name of anything a diagnosis may name, within a sentence: "trunnion tilt", "a jump of the
/// orientation", "misread values", "noise larger than stated".
QString causeName(const std::string& id);
/// The same name for sentences of the core.
std::string causeNameInCore(const std::string& id);
/// The name with a capital letter.
QString causeTitle(const std::string& id);
/// "a, b or c"; `last` separates the last two, blanks included: " or ".
QString causeNames(const std::vector<std::string>& ids, const QString& last);

/// "sag −0.298 mm (u 0.009)"; just the number if its name only repeats the effect's.
QString parameterText(const Cause& cause, const CauseParameter& parameter);

/// "0°, point 11, horizontal, off by 29.0″", with round and face unless they are 1.
QString deviationText(const ReadingDeviation& reading);
Place placeOf(const ReadingDeviation& reading);

/// The plausible size (1σ) of an effect's first number; empty outside the catalogue.
QString plausibleText(const std::string& id);

/// The verdict in a few words: "One cause: collimation".
QString gapHeadline(const Diagnosis& diagnosis);
/// The verdict in whole sentences.
QString diagnosisText(const Diagnosis& diagnosis);
/// The same, with the effects already in the session's model.
QString gapSentence(const Gap& gap);

/// "plane tilt ± 0.12 mm; gravity sag ± 0.05 mm": the change of Δd by a plausible size of each.
QString undetectableText(const std::vector<UndetectableEffect>& effects);

/// The model at this stage of the gap: "as modelled", "in the model: gravity sag", "+ collimation".
QString stageText(const Gap& gap, const GapStage& stage);

/// "−2.1675 ± 0.0421 mm", or "—" if absent.
QString estimateText(const std::optional<IntersectionEstimate>& estimate);

}  // namespace alidade::ui

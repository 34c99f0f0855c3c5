#include "ui/text/cause_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/list_text.h"
#include "core/diagnosis/decision.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/wording/cause_name.h"
#include "core/wording/closures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/gap_in_few_words.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct GapText {
  Q_DECLARE_TR_FUNCTIONS(GapText)
};

}  // namespace

QString causeName(const std::string& id) {
  return qText(alidade::causeName(id));
}

std::string causeNameInCore(const std::string& id) {
  return alidade::causeName(id);
}

QString causeTitle(const std::string& id) {
  QString name = causeName(id);
  for (const QString& article : {QStringLiteral("a "), QStringLiteral("the ")})
    if (name.startsWith(article)) name.remove(0, article.size());
  return capitalised(name);
}

QString causeNames(const std::vector<std::string>& ids, const QString& last) {
  std::vector<std::string> names;
  for (const std::string& id : ids) names.push_back(causeNameInCore(id));
  return qText(listed(names, last.toStdString()));
}

QString parameterText(const Cause& cause, const CauseParameter& parameter) {
  const QString figure = withStandardUncertainty(parameter.value, parameter.sigma, unitText(parameter.unit));
  if (isNamedBy(cause.effect, parameter.name)) return figure;
  //: a number of an effect and its size: sag −0.298 mm (u 0.009)
  return GapText::tr("%1 %2").arg(qText(parameterName(parameter.name)), figure);
}

QString deviationText(const ReadingDeviation& reading) {
  std::vector<std::string> where{positionText(reading.axisDeg, reading.time).toStdString(),
                                 GapText::tr("point %1").arg(reading.point).toStdString(),
                                 inWords(reading.kind)};
  if (reading.round != 1) where.push_back(GapText::tr("round %1").arg(reading.round).toStdString());
  if (reading.face != 1) where.push_back(GapText::tr("face %1").arg(reading.face).toStdString());
  //: a reading and its error: 0°, point 11, horizontal: off by +29.0″
  return GapText::tr("%1: off by %2")
      .arg(qText(listed(where)), signedNumberText(reading.size, 1) + QChar(0x2033));
}

Place placeOf(const ReadingDeviation& reading) {
  return {.position = reading.position, .reading = reading.row, .field = std::string(nameOf(reading.kind))};
}

QString gapHeadline(const Diagnosis& diagnosis) {
  return qText(gapInFewWords(diagnosis));
}

QString diagnosisText(const Diagnosis& diagnosis) {
  return qText(sentenceOf(diagnosis, causeNameInCore));
}

QString gapSentence(const Gap& gap) {
  QString text = diagnosisText(*gap.diagnosis);
  if (gap.diagnosis->verdict == DiagnosisVerdict::WithinNoise && isMisclosed(*gap.diagnosis))
    text += u' ' + qText(misclosureSentence(*gap.diagnosis));
  const GapStage& bare = gap.stages.front();
  if (bare.kind == GapStage::Kind::Bare && &bare != &gap.asModelled()) {
    std::vector<std::string> effects;
    for (const GapStage& stage : gap.stages)
      if (stage.kind == GapStage::Kind::InModel) effects.push_back(stage.effect);
    text += GapText::tr(" The model holds %1; without, the residuals are %2 instead of %3.")
                .arg(causeNames(effects, GapText::tr(" and ")), arcsecText(bare.rms),
                     arcsecText(gap.asModelled().rms));
  }
  return text;
}

namespace {

/// "without 2 misread values": each of these stages excludes more.
QString withoutGrossErrors(const Gap& gap, const GapStage& stage) {
  std::size_t all = 0, leftOut = 0;
  for (const GapStage& other : gap.stages) {
    if (other.effect == grossErrorId) all += other.grossErrors;
    if (&other == &stage) leftOut = all;
  }
  if (all == 1) return GapText::tr("without the misread value");
  return leftOut == 1 ? GapText::tr("without 1 misread value")
                      : GapText::tr("without %1 misread values").arg(leftOut);
}

}  // namespace

QString stageText(const Gap& gap, const GapStage& stage) {
  if (stage.kind == GapStage::Kind::Bare)
    return gap.asModelled().kind == GapStage::Kind::Bare ? GapText::tr("as modelled")
                                                         : GapText::tr("without model effects");
  if (stage.effect == grossErrorId) return withoutGrossErrors(gap, stage);
  if (stage.effect == knownId) return GapText::tr("+ what is known");
  const QString title = causeTitle(stage.effect), name = title.left(1).toLower() + title.mid(1);
  return stage.kind == GapStage::Kind::InModel ? GapText::tr("in the model: %1").arg(name)
                                               : QStringLiteral("+ ") + name;
}

QString undetectableText(const std::vector<UndetectableEffect>& effects) {
  QStringList texts;
  for (const UndetectableEffect& effect : effects)
    texts.append(QStringLiteral("%1 ± %2").arg(causeName(effect.effect),
                                               lengthText(effect.influence, decimalsFor(effect.influence))));
  return texts.join(QStringLiteral("; "));
}

QString plausibleText(const std::string& id) {
  const Effect* effect = effectById(id);
  return effect ? plausibleText(effect->parameters.front()) : QString();
}

QString estimateText(const std::optional<IntersectionEstimate>& estimate) {
  return estimate ? valueWithUncertainty(estimate->value, estimate->expanded, {}).trimmed() : notStated();
}

}  // namespace alidade::ui

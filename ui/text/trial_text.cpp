#include "ui/text/trial_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/effects/catalogue.h"
#include "core/session/face.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct TrialText {
  Q_DECLARE_TR_FUNCTIONS(TrialText)
};

QString signedSeconds(Angle angle) {
  return signedNumberText(angle.arcseconds(), 1) + QChar(0x2033);
}

/// The simulated size of a number: "+12.3″", "tilt about x +0.10°".
QString sizeText(const Effect& effect, const EffectParameter& parameter, double value) {
  const int decimals = std::min(9, decimalsFor(parameter.plausible) + 1);
  const QString size = withUnit(signedNumberText(value, decimals), unitText(std::string(parameter.unit)));
  if (effect.parameters.size() == 1) return size;
  //: a number of an effect and its size: tilt about x +0.10°
  return TrialText::tr("%1 %2").arg(qText(parameterName(parameter.name)), size);
}

void addEffects(QStringList& lines, const Truth& truth) {
  for (const Effect& effect : effectCatalogue()) {
    QStringList sizes;
    for (const EffectParameter& parameter : effect.parameters)
      for (const TrueSize& size : truth.effects)
        if (size.term == parameter.term) sizes.append(sizeText(effect, parameter, size.value));
    if (!sizes.isEmpty())
      //: an effect and its sizes
      lines.append(TrialText::tr("%1: %2").arg(causeTitle(std::string(effect.id)), listText(sizes)));
  }
}

/// The size is in mm or arcseconds, depending on the kind.
QString foreignText(const ForeignEffect& effect) {
  using Kind = ForeignEffect::Kind;
  const QString length = lengthText(effect.size, 3);
  const QString angle = arcsecText(effect.size, 1);
  switch (effect.kind) {
    case Kind::LocalDent:
      return TrialText::tr("A dent of the radius, %1 at s = %2°").arg(length, numberText(effect.first, 0));
    case Kind::CirclePeriods:
      return TrialText::tr("A horizontal circle error with %2 periods a turn, %1")
          .arg(angle, numberText(effect.first, 0));
    case Kind::Settling:
      return TrialText::tr("An instrument that settles, %1").arg(angle);
    case Kind::DistanceRamp:
      return TrialText::tr("A distance that grows by %1").arg(length);
    case Kind::Refraction:
      return TrialText::tr("Refraction, %1 · sin 2e").arg(angle);
    case Kind::Backlash:
      return TrialText::tr("Backlash of the horizontal circle, %1 on the way back").arg(angle);
    case Kind::HighWarp:
      break;
  }
  return TrialText::tr("A warp of order %2 out of the plane, %1").arg(length, numberText(effect.first, 0));
}

void addGrossErrors(QStringList& lines, const Truth& truth) {
  for (const TrueGrossError& error : truth.grossErrors) {
    const bool isHorizontal = error.horizontal.radians() != 0;
    lines.append(TrialText::tr("Misread: %1, round %2, point %3, %4, %5 by %6")
                     .arg(positionText(error.axisDeg, error.repeat))
                     .arg(error.round)
                     .arg(error.point)
                     .arg(qText(faceName(error.face)))
                     .arg(isHorizontal ? TrialText::tr("horizontal") : TrialText::tr("vertical"),
                          signedSeconds(isHorizontal ? error.horizontal : error.vertical)));
  }
}

}  // namespace

QString trialKindName(const std::string& kind) {
  if (kind == "none") return TrialText::tr("nothing");
  if (kind == "two_causes" || kind == "several_causes" || kind == "several-causes")
    return TrialText::tr("several causes");
  if (kind.rfind("unknown", 0) == 0) return TrialText::tr("an uncatalogued effect");
  if (kind == "within-noise") return TrialText::tr("no gap");
  if (kind == "not-in-catalogue") return TrialText::tr("no known cause");
  return causeName(kind);
}

QStringList truthLines(const BlindTrial& trial) {
  QStringList lines;
  const Truth& truth = trial.truth;
  addEffects(lines, truth);
  addGrossErrors(lines, truth);
  if (truth.jump)
    lines.append(TrialText::tr("Knocked after %1 % of the rows: horizontal %2, vertical %3")
                     .arg(numberText(100 * truth.jump->moment, 0), signedSeconds(truth.jump->horizontal),
                          signedSeconds(truth.jump->vertical)));
  if (truth.wrongZero)
    lines.append(TrialText::tr("Knocked after the pointing zero at %1: horizontal %2, vertical %3")
                     .arg(positionText(truth.wrongZero->axisDeg, truth.wrongZero->repeat),
                          signedSeconds(truth.wrongZero->horizontal),
                          signedSeconds(truth.wrongZero->vertical)));
  if (truth.harmonic)
    lines.append(TrialText::tr("Radius + A cos %1s + B sin %1s with A = %2 mm, B = %3 mm")
                     .arg(truth.harmonic->order)
                     .arg(numberText(truth.harmonic->cosine, 3), numberText(truth.harmonic->sine, 3)));
  if (truth.foreign) lines.append(foreignText(*truth.foreign));
  if (truth.noiseFactor != 1)
    lines.append(TrialText::tr("Noise: %1 times the stated noise").arg(numberText(truth.noiseFactor, 2)));
  if (lines.isEmpty()) lines.append(TrialText::tr("No error was simulated."));
  if (trial.seal.visible) {
    QString shows = TrialText::tr("The trace of the error in the readings is %1 σ")
                        .arg(numberText(*trial.seal.visible, 1));
    if (!trial.seal.lookAlikes.empty())
      shows += TrialText::tr("; in these readings it looks like %1")
                   .arg(causeNames(trial.seal.lookAlikes, TrialText::tr(" or ")));
    lines.append(shows + u'.');
  }
  lines.append(TrialText::tr("True Δd = %1 mm").arg(numberText(trial.seal.intersection, 4)));
  return lines;
}

QString scoreSentence(const SealedTruth& truth, const TrialScore& score) {
  const QString was = trialKindName(truth.kind), answer = trialKindName(score.answer);
  QString text;
  if (!score.right)
    text = TrialText::tr("The truth was %1; the diagnosis was %2.").arg(was, answer);
  else if (score.trialClass == TrialClass::Faint)
    text = score.named ? TrialText::tr("The error was found, although its trace is faint.")
                       : TrialText::tr("The trace of the error is too faint to be found.");
  else if (score.trialClass == TrialClass::LookAlikes)
    text = TrialText::tr(
        "The truth is in the group that the diagnosis names, which is no larger than necessary.");
  else
    text = TrialText::tr("The truth was %1; the diagnosis agrees.").arg(was);
  if (score.covered)
    text += *score.covered ? TrialText::tr(" Δd with the causes covers the true Δd.")
                           : TrialText::tr(" Δd with the causes misses the true Δd.");
  return text;
}

}  // namespace alidade::ui

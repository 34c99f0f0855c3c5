#include "ui/text/trial_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/effects/catalogue.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("BlindTrial", text);
}

QString signedSeconds(Angle angle) {
  return signedNumberText(angle.arcseconds(), 1) + QChar(0x2033);
}

/// "+12.3″".
QString sizeText(const EffectParameter& parameter, double value) {
  const int decimals = std::min(9, decimalsFor(parameter.plausible) + 1);
  return withUnit(signedNumberText(value, decimals), unitText(std::string(parameter.unit)));
}

void addEffects(QStringList& lines, const Truth& truth) {
  for (const Effect& effect : effectCatalogue()) {
    QStringList sizes;
    for (const EffectParameter& parameter : effect.parameters)
      for (const TrueSize& size : truth.effects)
        if (size.term == parameter.term)
          sizes.append(
              (effect.parameters.size() > 1 ? qText(std::string(parameter.name)) + u' ' : QString()) +
              sizeText(parameter, size.value));
    if (!sizes.isEmpty())
      lines.append(causeTitle(std::string(effect.id)) + QStringLiteral(": ") +
                   sizes.join(QStringLiteral(", ")));
  }
}

/// Its size is in mm or arcseconds, as the kind has it.
QString foreignText(const ForeignEffect& effect) {
  using Kind = ForeignEffect::Kind;
  const QString length = lengthText(effect.size, 3);
  const QString angle = arcsecText(effect.size, 1);
  switch (effect.kind) {
    case Kind::LocalDent:
      return translated("A dent of the radius, %1 at s = %2°").arg(length, numberText(effect.first, 0));
    case Kind::CirclePeriods:
      return translated("A horizontal circle with %2 periods a turn, %1")
          .arg(angle, numberText(effect.first, 0));
    case Kind::Settling:
      return translated("An instrument that settles, %1").arg(angle);
    case Kind::DistanceRamp:
      return translated("A distance that grows by %1").arg(length);
    case Kind::Refraction:
      return translated("Refraction, %1 · sin 2e").arg(angle);
    case Kind::Backlash:
      return translated("Backlash of the horizontal circle, %1 on the way back").arg(angle);
    case Kind::HighWarp:
      break;
  }
  return translated("A warp of order %2 out of the plane, %1").arg(length, numberText(effect.first, 0));
}

void addGrossErrors(QStringList& lines, const Truth& truth) {
  for (const TrueGrossError& error : truth.grossErrors) {
    const bool isHorizontal = error.horizontal.radians() != 0;
    lines.append(translated("Misread: %1°, round %2, point %3, face %4, %5 by %6")
                     .arg(error.axisDeg)
                     .arg(error.round)
                     .arg(error.point)
                     .arg(error.face)
                     .arg(isHorizontal ? translated("horizontal") : translated("vertical"),
                          signedSeconds(isHorizontal ? error.horizontal : error.vertical)));
  }
}

}  // namespace

QString trialKindName(const std::string& kind) {
  if (kind == "none") return translated("nothing");
  if (kind == "two_causes" || kind == "several_causes" || kind == "several-causes")
    return translated("several causes");
  if (kind.rfind("unknown", 0) == 0) return translated("an effect of no catalogue");
  if (kind == "within-noise") return translated("no gap");
  if (kind == "not-in-catalogue") return translated("no known cause");
  return causeName(kind);
}

QStringList truthLines(const BlindTrial& trial) {
  QStringList lines;
  const Truth& truth = trial.truth;
  addEffects(lines, truth);
  addGrossErrors(lines, truth);
  if (truth.jump)
    lines.append(translated("Knocked after %1 % of the rows: horizontal %2, vertical %3")
                     .arg(numberText(100 * truth.jump->moment, 0), signedSeconds(truth.jump->horizontal),
                          signedSeconds(truth.jump->vertical)));
  if (truth.harmonic)
    lines.append(translated("Radius + A cos %1s + B sin %1s with A = %2 mm, B = %3 mm")
                     .arg(truth.harmonic->order)
                     .arg(numberText(truth.harmonic->cosine, 3), numberText(truth.harmonic->sine, 3)));
  if (truth.foreign) lines.append(foreignText(*truth.foreign));
  if (truth.noiseFactor != 1)
    lines.append(translated("Noise %1 times the stated").arg(numberText(truth.noiseFactor, 2)));
  if (lines.isEmpty()) lines.append(translated("Nothing was put in."));
  if (trial.seal.visible) {
    QString shows = translated("It shows by %1 σ of the readings").arg(numberText(*trial.seal.visible, 1));
    if (!trial.seal.lookAlikes.empty())
      shows +=
          translated("; there it looks like %1").arg(causeNames(trial.seal.lookAlikes, translated("or")));
    lines.append(shows + u'.');
  }
  lines.append(translated("True Δd = %1 mm").arg(numberText(trial.seal.intersection, 4)));
  return lines;
}

QString scoreSentence(const SealedTruth& truth, const TrialScore& score) {
  const QString was = trialKindName(truth.kind), answer = trialKindName(score.answer);
  QString text;
  if (!score.right)
    text = translated("It was %1; the answer was %2.").arg(was, answer);
  else if (score.trialClass == TrialClass::Faint)
    text = score.named ? translated("Named, faint as it is.") : translated("Too faint to be expected.");
  else if (score.trialClass == TrialClass::LookAlikes)
    text = translated("It is in the group named, and the group is no larger than it must be.");
  else
    text = translated("It was %1, and so was the answer.").arg(was);
  if (score.covered)
    text += *score.covered ? translated(" Δd with the causes covers the true one.")
                           : translated(" Δd with the causes misses the true one.");
  return text;
}

}  // namespace alidade::ui

#include "ui/text/next_reading_text.h"

#include <QCoreApplication>
#include <cmath>

#include "core/evaluation/evaluation.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"
#include "core/session/session_fields.h"
#include "core/wording/guidance.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct NextReadingText {
  Q_DECLARE_TR_FUNCTIONS(NextReadingText)
};

constexpr int longestKey = 20;

/// The shortened text; empty if the text is the default of its field.
QString unusual(const RowField& field, const std::string& text) {
  return text == usualText(field) ? QString() : shortLine(text, longestKey);
}

QString keysText(const Reading& sighting) {
  QStringList parts{NextReadingText::tr("point %1").arg(shortLine(sighting.point, longestKey))};
  if (const QString round = unusual(rowField(&Reading::round), sighting.round); !round.isEmpty())
    parts.append(NextReadingText::tr("round %1").arg(round));
  if (const QString face = unusual(rowField(&Reading::face), sighting.face); !face.isEmpty())
    parts.append(face == u'2' ? qText(faceName(2)) : NextReadingText::tr("face %1").arg(face));
  return listText(parts);
}

/// The guide of the session's protocol; null if there is no protocol or it is invalid.
const Guide* guideIn(const Evaluation& evaluation) {
  const Guide* guide = evaluation.guide.get();
  return guide && guide->problem.empty() ? guide : nullptr;
}

}  // namespace

QString coarseAngleText(Angle angle, CircleUnit unit) {
  // The last place shown: a minute, a hundredth of a degree or of a gon. A full turn is shown as 0.
  const double perTurn = unit == CircleUnit::Gon ? 40'000 : unit == CircleUnit::Degrees ? 36'000 : 21'600;
  const double places = std::fmod(std::round(angle.degrees() / 360 * perTurn), perTurn);
  if (unit == CircleUnit::Gon) return numberText(places / 100, 2) + QStringLiteral(" gon");
  if (unit == CircleUnit::Degrees) return numberText(places / 100, 2) + u'°';
  const auto minutes = std::llround(std::abs(places));
  const QString sign = places < 0 ? QString(QChar(0x2212)) : QString();
  return sign + QStringLiteral("%1°%2′").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

QString sightingText(const Reading& sighting) {
  return capitalised(keysText(sighting));
}

std::optional<EntryToCome> entryToCome(const Evaluation& evaluation, std::size_t position) {
  if (position >= evaluation.next.size()) return std::nullopt;
  const Guide* guide = guideIn(evaluation);
  return entryToCome(evaluation.session, position, guide ? &guide->progress : nullptr);
}

std::optional<EntryToCome> entryToLeadTo(const Evaluation& evaluation, std::size_t position) {
  if (position >= evaluation.next.size()) return std::nullopt;
  const Guide* guide = guideIn(evaluation);
  return alidade::entryToLeadTo(evaluation.session, position, guide ? &guide->progress : nullptr);
}

std::optional<ExpectedReading> expectedOf(const Evaluation& evaluation, const EntryToCome& entry) {
  if (!entry.field.empty()) return std::nullopt;
  if (const Guide* guide = guideIn(evaluation); guide && guide->progress.next)
    return guide->expected[*guide->progress.next];
  const auto& next = evaluation.next[entry.position];
  if (!entry.zero.empty() || !next) return std::nullopt;
  const Reading &a = next->sighting, &b = entry.sighting;
  return a.point == b.point && a.round == b.round && a.face == b.face ? next->expected : std::nullopt;
}

QString entryText(const Session& session, const EntryToCome& entry) {
  if (!entry.field.empty())
    return capitalised(QCoreApplication::translate("Field", sessionFieldNamed(entry.field)->noun));
  const QString where = positionText(session, entry.position);
  if (entry.zero.empty()) return NextReadingText::tr("%1: %2").arg(where, sightingText(entry.sighting));
  PlannedSighting zero;
  zero.isZero = true;
  zero.isAfter = entry.isAfter;
  zero.face = entry.zeroFace;
  return NextReadingText::tr("%1: %2").arg(where, qText(sightingName(zero)));
}

QString nextEntryText(const Evaluation& evaluation, std::size_t position) {
  const auto entry = entryToLeadTo(evaluation, position);
  if (!entry)
    return position < evaluation.next.size() ? NextReadingText::tr("All readings are taken") : QString();
  if (!entry->field.empty() || !entry->zero.empty() || entry->position != position)
    return NextReadingText::tr("Next: %1").arg(entryText(evaluation.session, *entry));
  return nextReadingText({entry->row, entry->sighting, expectedOf(evaluation, *entry)},
                         circleUnitOf(evaluation.session));
}

QString nextReadingText(const NextReading& next, CircleUnit unit) {
  const QString text = NextReadingText::tr("Next: %1").arg(keysText(next.sighting));
  if (!next.expected) return text;
  return NextReadingText::tr("%1, about %2 and %3")
      .arg(text, coarseAngleText(next.expected->horizontal, unit),
           coarseAngleText(next.expected->vertical, unit));
}

}  // namespace alidade::ui

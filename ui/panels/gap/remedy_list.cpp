#include "ui/panels/gap/remedy_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "core/effects/cause_ids.h"
#include "core/session/protocol_progress.h"
#include "core/wording/diagnosis_sentence.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/text/accessible_place.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

/// Advice about a jump: which rows may be excluded, and the condition for it. The remaining rows must have
/// the same orientation as every pointing zero that they use.
QString jumpText(const Session& session, const Jump& jump) {
  if (jump.isAtZero)
    return RemedyList::tr(
        "The jump happened between a pointing zero and the first place after it, or that zero was misread; "
        "these readings do not show in which position. A jump cannot be added to the model: sight both zeros "
        "again and repeat the positions.");
  const QString row =
      accessiblePlace(session, {.position = jump.place.position, .reading = jump.place.reading});
  QString text = RemedyList::tr(
                     "The jump happened before %1. A jump cannot be added to the model: check the tripod or "
                     "pillar, sight the pointing zero again and repeat this position.")
                     .arg(row);
  if (jump.before)
    text += RemedyList::tr(
        " Or leave out the rows before the jump, if the pointing zero of the next position was not sighted "
        "after the jump.");
  if (jump.after && jump.isLast)
    text += RemedyList::tr(" Or leave out the rows after the jump.");
  else if (jump.after)
    text += jump.before
                ? RemedyList::tr(
                      " Or leave out the rows after the jump, if that zero was sighted after the jump.")
                : RemedyList::tr(
                      " Or leave out the rows after the jump, if the pointing zero of the next position was "
                      "sighted after the jump.");
  return text;
}

Place placeOf(const ReadingDeviation& reading) {
  const std::string circle(nameOf(reading.kind));
  if (!reading.isZero) return {.position = reading.position, .reading = reading.row, .field = circle};
  PlannedSighting zero;
  zero.isAfter = reading.isAfter;
  zero.face = reading.face;
  return {.position = reading.position, .reading = {}, .field = zeroField(zero) + "." + circle};
}

}  // namespace

RemedyList::RemedyList(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(3);
}

void RemedyList::setGap(const Gap& gap) {
  while (QLayoutItem* item = m_layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  m_buttons = nullptr;
  for (const Cause& cause : gap.diagnosis->causes) {
    m_buttons = nullptr;
    if (cause.effect == grossErrorId) addGrossErrors(cause);
    if (cause.effect == jumpId) addJump(gap, cause);
    if (cause.effect == noiseId) addNoise(gap, cause);
    if (cause.effect == relationId) addRelation(gap);
  }
  setVisible(m_layout->count() > 0);
}

void RemedyList::addText(const QString& text) {
  QLabel* label = wrappedLabel();
  label->setText(text);
  m_layout->addWidget(label);
}

QPushButton* RemedyList::addButton(const QString& text, const QString& name) {
  if (!m_buttons) {
    auto* row = new QWidget;
    m_buttons = new QHBoxLayout(row);
    m_buttons->setContentsMargins(0, 2, 0, 0);
    m_buttons->addStretch();
    m_layout->addWidget(row);
  }
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAutoDefault(true);
  m_buttons->insertWidget(m_buttons->count() - 1, button);
  return button;
}

void RemedyList::addRelation(const Gap& gap) {
  const bool isPlanar = gap.evaluation->examined.measurement->relation == VerticalAngleRelation::Planar;
  QPushButton* relation =
      addButton(isPlanar ? tr("Set the relation to exact") : tr("Set the relation to planar"),
                QStringLiteral("relation"));
  relation->setToolTip(
      tr("Sets “Relation” (vertical angle) in the Measurement form; this effect then need not be estimated"));
  connect(relation, &QPushButton::clicked, this, [this, isPlanar] {
    emit relationWanted(isPlanar ? QStringLiteral("exact") : QStringLiteral("planar"));
  });
}

void RemedyList::addGrossErrors(const Cause& cause) {
  if (!cause.indistinguishableFrom.empty())
    addText(
        tr("The cause may also be %1, which would move Δd: read the position again before you exclude a row.")
            .arg(causeNames(cause.indistinguishableFrom, tr(" or "))));
  for (const ReadingDeviation& reading : cause.readings) {
    m_buttons = nullptr;
    //: a reading and its error: 0°, point 11, horizontal: off by +29.0″
    addText(tr("%1: off by %2").arg(qText(readingName(reading)), qText(secondsWithSign(reading.size))));
    const Place place = placeOf(reading);
    connect(addButton(tr("Go to the reading"), QStringLiteral("go to reading")), &QPushButton::clicked, this,
            [this, place] { emit placeActivated(place); });
    if (reading.isZero) {
      addText(
          tr("Correct this sighting of the pointing zero, or clear it: the zero is the mean of the others."));
      continue;
    }
    QPushButton* exclude = addButton(tr("Exclude the row"), QStringLiteral("exclude row"));
    exclude->setToolTip(tr("Excludes the row from the fit; its entries are kept"));
    connect(exclude, &QPushButton::clicked, this, [this, place] { emit exclusionWanted(place); });
  }
}

/// Shows advice and actions for a jump, which no session model includes: it has a time as well as a size.
void RemedyList::addJump(const Gap& gap, const Cause& cause) {
  const std::optional<Jump> jump = jumpOf(gap, cause);
  if (!jump) return;
  addText(jumpText(gap.evaluation->session, *jump));
  connect(addButton(tr("Go to the reading"), QStringLiteral("go to jump")), &QPushButton::clicked, this,
          [this, place = jump->place] { emit placeActivated(place); });
  if (jump->before && jump->after) m_buttons = nullptr;  // three buttons in a row are wider than the page
  if (jump->before)
    addRowsExclusion(tr("Exclude rows before the jump"), QStringLiteral("exclude before"), *jump->before);
  if (jump->after)
    addRowsExclusion(tr("Exclude rows after the jump"), QStringLiteral("exclude after"), *jump->after);
}

void RemedyList::addRowsExclusion(const QString& text, const QString& name, const RowRange& rows) {
  QPushButton* exclude = addButton(text, name);
  exclude->setToolTip(tr("Excludes the rows from the fit; their entries are kept"));
  connect(exclude, &QPushButton::clicked, this, [this, rows] { emit rowsExclusionWanted(rows); });
}

void RemedyList::addNoise(const Gap& gap, const Cause& cause) {
  addText(
      tr("Nothing to add to the model: U already includes the scatter of the readings. If such scatter is "
         "usual for this instrument and site, state the larger σ."));
  const std::optional<StatedNoise> noise = scatterOf(gap, cause);
  if (!noise) return;
  const QString second = QChar(0x2033);
  const QString both =
      noise->horizontal == noise->vertical
          ? qText(noise->horizontal) + second
          : tr("%1 and %2").arg(qText(noise->horizontal) + second, qText(noise->vertical) + second);
  QPushButton* state = addButton(tr("State σ = %1").arg(both), QStringLiteral("state noise"));
  state->setToolTip(
      tr("Sets σ of the horizontal and the vertical circle in the Instrument form; σ of the pointing zero "
         "changes with them unless it was typed"));
  connect(state, &QPushButton::clicked, this, [this, noise = *noise] { emit noiseWanted(noise); });
}

}  // namespace alidade::ui

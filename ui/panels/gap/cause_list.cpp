#include "ui/panels/gap/cause_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "core/base/phrase.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/verdict.h"
#include "ui/settings/theme.h"
#include "ui/text/accessible_place.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// The assumptions behind a probability.
QString givenText(const std::string& id) {
  const QString plausible = plausibleText(id);
  if (plausible.isEmpty())
    return CauseList::tr("Probability that it is among the causes, given the catalogue");
  return CauseList::tr(
             "Probability that it is among the causes, given the catalogue\nand a plausible size of %1 (1σ)")
      .arg(plausible);
}

QString parametersText(const Cause& cause) {
  QStringList texts;
  for (const CauseParameter& parameter : cause.parameters)
    if (parameter.sigma > 0) texts.append(parameterText(cause, parameter));
  return texts.join(QStringLiteral(", "));
}

/// Advice about a jump, and which rows may be excluded when. Rows for which the orientation of every pointing
/// zero is still valid stay.
QString jumpText(const Session& session, const Jump& jump) {
  if (jump.isAtZero)
    return CauseList::tr(
        "It happened between a pointing zero and the first place after it, or that zero was misread; in "
        "which of the positions these readings do not tell. No model of a session holds a jump, so there is "
        "none to add: sight both zeros again and read the positions anew.");
  const QString row =
      accessiblePlace(session, {.position = jump.place.position, .reading = jump.place.reading});
  QString text = CauseList::tr(
                     "It happened before %1. No model of a session holds a jump, so there is none to add: "
                     "look after the "
                     "stand, sight the pointing zero anew and read this position again.")
                     .arg(row);
  if (jump.before)
    text += CauseList::tr(
        " Or leave out the rows before the jump, if the pointing zero of the next position was not sighted "
        "after it.");
  if (jump.after && jump.isLast)
    text += CauseList::tr(" Or leave out the rows from there on.");
  else if (jump.after)
    text += jump.before
                ? CauseList::tr(" Or leave out the rows from there on, if it was.")
                : CauseList::tr(
                      " Or leave out the rows from there on, if the pointing zero of the next position "
                      "was sighted after it.");
  return text;
}

}  // namespace

CauseList::CauseList(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(3);
}

void CauseList::setGap(const Gap& gap) {
  while (QLayoutItem* item = m_layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  m_buttons = nullptr;
  if (!gap.diagnosis) return;
  for (const Cause& cause : gap.diagnosis->causes) addCause(gap, cause);
  addAllCauses(gap.diagnosis->causes);
  if (tellsShape(*gap.diagnosis)) addShape(*gap.diagnosis->shape);
  for (const GapStage& stage : gap.stages)
    if (stage.kind == GapStage::Kind::InModel) addEffectOfModel(gap, stage.effect);
}

void CauseList::addTitle(const QString& text, const QString& figure, const QString& toolTip) {
  m_buttons = nullptr;
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, m_layout->isEmpty() ? 0 : 8, 0, 0);
  auto* title = new QLabel(text);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  auto* beside = new QLabel(figure);
  beside->setToolTip(toolTip);
  beside->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(title);
  layout->addStretch();
  layout->addWidget(beside);
  m_layout->addWidget(row);
}

void CauseList::addText(const QString& text, bool isQuiet) {
  if (text.isEmpty()) return;
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (isQuiet) label->setForegroundRole(QPalette::PlaceholderText);
  m_layout->addWidget(label);
}

QPushButton* CauseList::addButton(const QString& text, const QString& name) {
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

void CauseList::addCause(const Gap& gap, const Cause& cause) {
  addTitle(causeTitle(cause.effect), qText(shortProbabilityText(cause.probability)), givenText(cause.effect));
  addText(parametersText(cause));
  if (const Effect* effect = effectById(cause.effect))
    //: what an effect is, as a sentence of its own
    addText(tr("%1.").arg(capitalised(qText(Phrase::of(effect->description)))), true);
  if (!cause.indistinguishableFrom.empty() && gap.diagnosis->causes.size() > 1)
    addText(tr("These readings cannot tell it from %1.")
                .arg(causeNames(cause.indistinguishableFrom, tr(" or "))));
  if (cause.effect == grossErrorId) return addGrossErrors(cause);
  if (cause.effect == jumpId) return addJump(gap, cause);
  if (cause.effect == noiseId) return addNoise(gap, cause);
  addCatalogueButtons(gap, cause);
}

void CauseList::addCatalogueButtons(const Gap& gap, const Cause& cause) {
  const QString id = qText(cause.effect);
  if (cause.effect == relationId) {
    const bool isPlanar = gap.evaluation->examined.measurement->relation == VerticalAngleRelation::Planar;
    QPushButton* relation =
        addButton(isPlanar ? tr("Take exact vertical angles") : tr("Take planar vertical angles"),
                  QStringLiteral("relation"));
    relation->setToolTip(
        tr("Sets the relation of the vertical angle in the form of the measurement: no "
           "effect has to be estimated then"));
    connect(relation, &QPushButton::clicked, this, [this, isPlanar] {
      emit relationWanted(isPlanar ? QStringLiteral("exact") : QStringLiteral("planar"));
    });
  }
  QPushButton* add = addButton(tr("Add to the model"), QStringLiteral("add ") + id);
  add->setToolTip(tr("Estimates %1 along with the arcs; undone by Ctrl+Z").arg(causeName(cause.effect)));
  add->setAccessibleName(tr("Add %1 to the model").arg(causeName(cause.effect)));
  connect(add, &QPushButton::clicked, this, [this, id] { emit effectsWanted({id}); });
  QStringList all{id};
  for (const std::string& other : cause.indistinguishableFrom)
    if (effectById(other)) all.append(qText(other));
  if (all.size() < 2) return;
  QPushButton* group = addButton(all.size() == 2 ? tr("Add both") : tr("Add all %1").arg(all.size()),
                                 QStringLiteral("add group"));
  group->setToolTip(
      tr("Estimates all that look alike here, each within its plausible size: U then covers "
         "whichever it is"));
  connect(group, &QPushButton::clicked, this, [this, all] { emit effectsWanted(all); });
}

/// Offered for several causes that the model can hold.
void CauseList::addAllCauses(const std::vector<Cause>& causes) {
  QStringList all;
  for (const Cause& cause : causes)
    if (effectById(cause.effect)) all.append(qText(cause.effect));
  if (all.size() < 2) return;
  m_buttons = nullptr;
  connect(
      addButton(all.size() == 2 ? tr("Add both to the model") : tr("Add all %1 to the model").arg(all.size()),
                QStringLiteral("add all")),
      &QPushButton::clicked, this, [this, all] { emit effectsWanted(all); });
}

void CauseList::addGrossErrors(const Cause& cause) {
  if (!cause.indistinguishableFrom.empty())
    addText(
        tr("Perhaps %1 right beside it, which would move Δd: read the position again before a row is left "
           "out.")
            .arg(causeNames(cause.indistinguishableFrom, tr(" or "))));
  for (const ReadingDeviation& reading : cause.readings) {
    m_buttons = nullptr;
    addText(deviationText(reading));
    const Place place = placeOf(reading);
    connect(addButton(tr("Go to the reading"), QStringLiteral("go to reading")), &QPushButton::clicked, this,
            [this, place] { emit placeActivated(place); });
    QPushButton* exclude = addButton(tr("Exclude the row"), QStringLiteral("exclude row"));
    exclude->setToolTip(tr("Leaves the row out of the fit; what was typed stays"));
    connect(exclude, &QPushButton::clicked, this, [this, place] { emit exclusionWanted(place); });
  }
}

/// A jump has a time as well as a size, so no session model holds it.
void CauseList::addJump(const Gap& gap, const Cause& cause) {
  const std::optional<Jump> jump = jumpOf(gap, cause);
  if (!jump) return;
  addText(jumpText(gap.evaluation->session, *jump));
  connect(addButton(tr("Go to the reading"), QStringLiteral("go to jump")), &QPushButton::clicked, this,
          [this, place = jump->place] { emit placeActivated(place); });
  if (jump->before && jump->after) m_buttons = nullptr;  // three in a row are wider than the page
  if (jump->before)
    addRowsExclusion(tr("Exclude the rows before"), QStringLiteral("exclude before"), *jump->before);
  if (jump->after)
    addRowsExclusion(tr("Exclude the rows from there on"), QStringLiteral("exclude after"), *jump->after);
}

void CauseList::addRowsExclusion(const QString& text, const QString& name, const RowRange& rows) {
  QPushButton* exclude = addButton(text, name);
  exclude->setToolTip(tr("Leaves the rows out of the fit; what was typed stays"));
  connect(exclude, &QPushButton::clicked, this, [this, rows] { emit rowsExclusionWanted(rows); });
}

void CauseList::addNoise(const Gap& gap, const Cause& cause) {
  addText(
      tr("Nothing to add to the model: U rests on the scatter of the readings already. If the instrument and "
         "the place are no better than this, state the larger σ."));
  const std::optional<StatedNoise> noise = scatterOf(gap, cause);
  if (!noise) return;
  const QString second = QChar(0x2033);
  const QString both =
      noise->horizontal == noise->vertical
          ? qText(noise->horizontal) + second
          : tr("%1 and %2").arg(qText(noise->horizontal) + second, qText(noise->vertical) + second);
  QPushButton* state = addButton(tr("State σ = %1").arg(both), QStringLiteral("state noise"));
  state->setToolTip(
      tr("Sets σ of the horizontal and the vertical circle in the form of the instrument; σ of the pointing "
         "zero follows unless it was typed"));
  connect(state, &QPushButton::clicked, this, [this, noise = *noise] { emit noiseWanted(noise); });
}

void CauseList::addShape(const GapShape& shape) {
  addTitle(tr("Shape of the gap"), numberText(100 * shape.share, 0) + QStringLiteral(" %"));
  addText(tr("It follows the pattern “%1”, which takes up %2 % of the gap. No effect of the catalogue makes "
             "it, so nothing can be added to the model: look at what in the set-up has this shape.")
              .arg(qText(patternName(shape)), numberText(100 * shape.share, 0)));
}

void CauseList::addEffectOfModel(const Gap& gap, const std::string& id) {
  addTitle(causeTitle(id), tr("in the model"));
  const auto& estimates = gap.evaluation->fit.effects;
  Cause cause{.effect = id, .parameters = {}, .indistinguishableFrom = {}, .readings = {}};
  for (const EffectEstimate& estimate : estimates)
    if (estimate.effect == id)
      cause.parameters.push_back({estimate.name, estimate.value, estimate.sigma, estimate.unit});
  addText(parametersText(cause));
  QPushButton* remove = addButton(tr("Take out of the model"), QStringLiteral("remove ") + qText(id));
  remove->setAccessibleName(tr("Take %1 out of the model").arg(causeName(id)));
  connect(remove, &QPushButton::clicked, this, [this, id] { emit effectUnwanted(qText(id)); });
}

}  // namespace alidade::ui

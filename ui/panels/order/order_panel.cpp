#include "ui/panels/order/order_panel.h"

#include <QDoubleSpinBox>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "core/evaluation/guide.h"
#include "core/guidance/advised_protocol.h"
#include "core/session/entry.h"
#include "core/session/session_fields.h"
#include "core/simulation/protocol.h"
#include "core/statement/next_measures.h"
#include "core/statement/sighting_choice.h"
#include "core/wording/guidance.h"
#include "core/wording/measure.h"
#include "core/wording/position_name.h"
#include "ui/commands/change_session.h"
#include "ui/document/session_document.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/parts/protocol_menu.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QLabel* textLabel(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

bool isAlike(const Evaluation& one, const Evaluation& other) {
  return isSameMeasurement(one.session, other.session);
}

/// The first advice of the diagnosis on further readings that a protocol can include; empty if there is none.
std::vector<Measure> adviceOf(const SharedGap& gap) {
  if (gap && gap->found())
    for (const std::vector<Measure>& measures : measuresNext(*gap))
      if (std::ranges::all_of(measures, isForProtocol)) return measures;
  return {};
}

/// The name that the author gave the protocol; for one of the program's protocols, its sightings in words.
QString nameOf(const SightingProtocol& protocol) {
  constexpr int longest = 60;
  const bool isOurs = protocol.name.empty() || protocolByName(protocol.name);
  return shortLine(isOurs ? protocolInWords(protocol) : protocol.name, longest);
}

QString listedLater() {
  return OrderPanel::tr(
             "The sightings needed for “U to reach” are listed here once L, R0 and a reading are entered (up "
             "to %1 rows).")
      .arg(mostForChoice);
}

}  // namespace

OrderPanel::OrderPanel(SessionDocument& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_evaluation(std::make_shared<const Evaluation>()),
      m_choice(new QToolButton),
      m_menu(new QMenu(this)),
      m_progress(new QProgressBar),
      m_next(textLabel(QStringLiteral("next sighting"))),
      m_expected(textLabel(QStringLiteral("expected reading"))),
      m_state(textLabel(QStringLiteral("order state"))),
      m_outlook(textLabel(QStringLiteral("order outlook"))),
      m_repeats(textLabel(QStringLiteral("order repeats"))),
      m_uncertainty(new QDoubleSpinBox),
      m_choiceMade(new StatementView),
      m_ahead(new StatementView),
      m_table(createTable()) {
  m_table->setAccessibleName(tr("Sightings of the protocol"));
  m_table->setPlaceholder(tr("The session follows no protocol. Choose one by “Protocol”."));
  setFocusProxy(m_table);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(createSummary(), 1);
  layout->addWidget(m_table, 1);
  connect(m_table, &DataTable::rowActivated, this, &OrderPanel::activate);
  connect(m_menu, &QMenu::aboutToShow, this, &OrderPanel::fillMenu);
  connect(&m_job, &OutlookJob::found, this, &OrderPanel::showOutlook);
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    if (change.kind == SessionChange::Kind::Everything) m_isUncertaintyTyped = false;
  });
  showSummary();
}

QWidget* OrderPanel::createSummary() {
  m_choice->setText(tr("Protocol"));
  m_choice->setObjectName(QStringLiteral("protocol choice"));
  m_choice->setPopupMode(QToolButton::InstantPopup);
  m_choice->setToolButtonStyle(Qt::ToolButtonTextOnly);
  m_choice->setMenu(m_menu);
  m_choice->setFocusPolicy(Qt::StrongFocus);
  m_choice->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  m_choice->setMinimumWidth(m_choice->fontMetrics().horizontalAdvance(tr("Protocol")) * 2);
  m_progress->setAccessibleName(tr("Sightings taken"));
  m_progress->setTextVisible(true);
  QFont large = m_expected->font();
  large.setPointSizeF(large.pointSizeF() * 1.7);
  large.setBold(true);
  m_expected->setFont(large);
  m_expected->setAccessibleName(tr("Expected reading"));
  m_next->setAccessibleName(tr("Next sighting"));
  auto* inside = new QWidget;
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(0, 0, 6, 0);
  column->addWidget(m_choice);
  column->addWidget(m_progress);
  for (QWidget* part : std::initializer_list<QWidget*>{m_next, m_expected, m_choiceMade, createUncertainty(),
                                                       m_ahead, m_state, m_outlook, m_repeats})
    column->addWidget(part);
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setAccessibleName(tr("Progress of the protocol"));
  scroll->setWidget(inside);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll;
}

QWidget* OrderPanel::createUncertainty() {
  constexpr double most = 100;  // mm
  m_uncertainty->setRange(0, most);
  m_uncertainty->setDecimals(4);
  m_uncertainty->setSingleStep(0.01);
  m_uncertainty->setSuffix(tr(" mm"));
  m_uncertainty->setSpecialValueText(tr("none"));
  m_uncertainty->setKeyboardTracking(false);
  m_uncertainty->setToolTip(
      tr("Lists the sightings that reach this U of Δd in the fewest minutes. Type 0 for a third of the "
         "tolerance"));
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins({});
  auto* caption = new QLabel(tr("U to reach"));
  caption->setBuddy(m_uncertainty);
  layout->addWidget(caption);
  layout->addWidget(m_uncertainty);
  layout->addStretch(1);
  connect(m_uncertainty, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    m_isUncertaintyTyped = value > 0;
    requestOutlook();
  });
  return row;
}

DataTable* OrderPanel::createTable() {
  const auto left = Qt::AlignLeft;
  return new DataTable({
      {tr("Axis"), tr("Position of the axis"), QStringLiteral("180° again"),
       [this](int row) {
         const PlannedSighting& planned = sighting(row).planned;
         return qText(positionName(planned.axisDeg, planned.repeat));
       },
       left},
      {tr("Sighting"), tr("Place with round and face, or pointing zero"), tr("pointing zero, face 2"),
       [this](int row) { return qText(sightingName(sighting(row).planned)); }, left},
      {tr("State"), tr("Whether the sighting has been taken"), tr("skipped"),
       [this](int row) { return qText(stateName(sighting(row).state)); }, left},
      {tr("Horizontal"), tr("Expected reading of the horizontal circle"), QStringLiteral("359.99 gon"),
       [this](int row) { return expectedText(row, true); }},
      {tr("Vertical"), tr("Expected reading of the vertical circle"), QStringLiteral("359.99 gon"),
       [this](int row) { return expectedText(row, false); }},
      {tr("Remark"), tr("Why the sighting must be taken again, or whether it was taken out of order"),
       tr("take again"), [this](int row) { return remarkText(row); }, left},
  });
}

const FollowedSighting& OrderPanel::sighting(int row) const {
  return m_evaluation->guide->progress.sightings[static_cast<std::size_t>(row)];
}

QString OrderPanel::expectedText(int row, bool isHorizontal) const {
  const auto& expected = m_evaluation->guide->expected[static_cast<std::size_t>(row)];
  if (!expected) return {};
  return coarseAngleText(isHorizontal ? expected->horizontal : expected->vertical,
                         circleUnitOf(m_evaluation->session));
}

QString OrderPanel::remarkText(int row) const {
  const auto index = static_cast<std::size_t>(row);
  for (const SightingsToRepeat& toRepeat : m_evaluation->guide->allToRepeat)
    if (std::ranges::find(toRepeat.sightings, index) != toRepeat.sightings.end()) return tr("take again");
  return sighting(row).isOutOfTurn ? tr("out of order") : QString();
}

void OrderPanel::activate(int row) {
  const FollowedSighting& followed = sighting(row);
  if (!followed.position) return;
  if (followed.planned.isZero)
    emit placeActivated(
        {.position = followed.position, .field = zeroField(followed.planned) + ".horizontal"});
  else if (followed.row)
    emit placeActivated({.position = followed.position, .reading = followed.row, .field = "horizontal"});
}

const Guide* OrderPanel::guideThatLeads() const {
  const Guide* guide = m_evaluation->guide.get();
  return guide && guide->problem.empty() ? guide : nullptr;
}

void OrderPanel::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = m_searched && isAlike(*m_searched, *evaluation) ? m_searched : evaluation;
  const Guide* guide = guideThatLeads();
  m_table->setRows(guide ? static_cast<int>(guide->progress.sightings.size()) : 0);
  showSummary();
  goToNext();
  requestOutlook();
}

/// Scrolls only when the next sighting changes, so that the user can look elsewhere in the list.
void OrderPanel::goToNext() {
  const Guide* guide = guideThatLeads();
  const ListedNext listed{m_table->model()->rowCount(),
                          guide ? guide->progress.next : std::optional<std::size_t>()};
  if (listed == std::exchange(m_listedNext, listed)) return;
  if (!listed.next) return m_table->clearSelection();
  const int row = static_cast<int>(*listed.next);
  m_table->selectDataRows({row});
  m_table->scrollTo(m_table->model()->index(row, 0),
                    DataTable::PositionAtCenter);  // shows the following sightings too
}

void OrderPanel::setSearched(const SharedEvaluation& evaluation) {
  m_searched = evaluation;
  if (isVisible() && evaluation->guide != m_evaluation->guide && isAlike(*evaluation, *m_evaluation))
    setEvaluation(evaluation);
}

void OrderPanel::setGap(const SharedGap& gap) {
  m_gap = gap;
  const Guide* guide = guideThatLeads();
  if (isVisible() && gapOfThis() && guide) requestOutlook();
}

SharedGap OrderPanel::gapOfThis() const {
  return m_gap && isAlike(*m_gap->evaluation, *m_evaluation) ? m_gap : nullptr;
}

void OrderPanel::requestOutlook() {
  const Guide* guide = guideThatLeads();
  const bool isByWorth = guide && guide->protocol.isByWorth;
  m_uncertainty->parentWidget()->setVisible(isByWorth);
  if (isByWorth) return requestAhead();
  m_ahead->setEnabled(false);
  if (guide && m_evaluation->examined.measurement) return m_job.request(m_evaluation, gapOfThis(), 0);
  m_job.cancel();
  m_ahead->setStatement(std::nullopt);
  m_outlook->clear();
}

void OrderPanel::requestAhead() {
  const auto& measurement = m_evaluation->examined.measurement;
  double wanted = m_uncertainty->value();
  if (!m_isUncertaintyTyped) {
    constexpr double ofTolerance = 1.0 / 3;
    const QSignalBlocker isNotTyped(m_uncertainty);
    wanted = measurement ? measurement->tolerance.value_or(0) * ofTolerance : 0;
    m_uncertainty->setValue(wanted);
  }
  m_outlook->clear();
  if (measurement && wanted > 0) {
    m_ahead->setEnabled(false);
    return m_job.request(m_evaluation, gapOfThis(), wanted);
  }
  m_job.cancel();
  m_ahead->setStatement(std::nullopt);
  m_outlook->setText(
      measurement ? tr("Enter the U of Δd to reach: the sightings that reach it soonest are listed here.")
                  : listedLater());
}

void OrderPanel::showSummary() {
  const Guide* guide = m_evaluation->guide.get();
  const bool isLed = guideThatLeads();
  m_progress->setVisible(isLed);
  m_state->setText(isLed   ? qText(progressSentences(guide->progress))
                   : guide ? visibleLine(guide->problem)
                           : tr("A protocol shows the next sighting and its expected reading, which "
                                "sightings remain, which to repeat, and when the readings suffice."));
  QStringList allToRepeat;
  if (isLed) {
    for (const SightingsToRepeat& toRepeat : guide->allToRepeat)
      allToRepeat.append(qText(repeatSentence(toRepeat, guide->progress)));
    const int count = static_cast<int>(guide->progress.sightings.size());
    m_progress->setMaximum(std::max(1, count));
    m_progress->setValue(static_cast<int>(guide->progress.taken));
    const int number = guide->progress.next ? static_cast<int>(*guide->progress.next) + 1 : count;
    m_progress->setFormat(guide->protocol.isByWorth
                              ? tr("%1 of at most %2 taken").arg(guide->progress.taken).arg(count)
                              : tr("sighting %1 of %2").arg(number).arg(count));
    const QFontMetrics metrics = m_choice->fontMetrics();
    m_choice->setText(metrics.elidedText(tr("Protocol: %1").arg(nameOf(guide->protocol)), Qt::ElideRight,
                                         36 * metrics.horizontalAdvance(u'0')));
    m_choice->setToolTip(qText(protocolInWords(guide->protocol)));
  } else {
    m_choice->setText(tr("Protocol"));
  }
  m_choiceMade->setStatement(isLed && guide->choice
                                 ? std::optional(sightingChoiceStatement(*guide->choice, guide->progress))
                                 : std::nullopt);
  m_repeats->setText(allToRepeat.join(u'\n'));
  m_repeats->setVisible(!allToRepeat.isEmpty());
  showNext();
}

void OrderPanel::showNext() {
  const Guide* guide = guideThatLeads();
  m_next->setVisible(guide);
  m_expected->setVisible(false);
  if (!guide) return;
  if (!guide->progress.next) return m_next->setText(tr("The protocol is complete."));
  const std::size_t next = *guide->progress.next;
  m_next->setText(
      tr("Next at %1").arg(qText(sightingNameInSession(guide->progress.sightings[next].planned))));
  const auto& expected = guide->expected[next];
  m_expected->setVisible(expected.has_value());
  if (!expected) return;
  const CircleUnit unit = circleUnitOf(m_evaluation->session);
  m_expected->setText(tr("%1   %2").arg(coarseAngleText(expected->horizontal, unit),
                                        coarseAngleText(expected->vertical, unit)));
}

void OrderPanel::showOutlook(const SharedOutlook& outlook) {
  if (outlook->evaluation != m_evaluation) return;
  m_ahead->setStatement(outlook->ahead ? sightingsAheadStatement(*outlook->ahead, m_uncertainty->value())
                                       : insteadStatement(outlook->outlook));
  m_outlook->setText(outlookText(*outlook));
}

QString OrderPanel::outlookText(const OutlookOfSession& outlook) const {
  const Guide& guide = *m_evaluation->guide;
  if (!outlook.failure.empty()) return qText(outlook.failure);
  if (guide.protocol.isByWorth) return outlook.ahead ? QString() : listedLater();
  const QString text = qText(outlookSentences(outlook.outlook, guide.progress)),
                first = qText(repeatsFirst(guide.allToRepeat));
  return first.isEmpty() ? text : tr("%1 %2").arg(first, text);
}

void OrderPanel::fillMenu() {
  m_menu->clear();
  addNamedProtocols(*m_menu, [this](const SightingProtocol& protocol) { follow(protocol); });
  m_menu->setToolTipsVisible(true);
  m_menu->addSeparator();
  const SightingProtocol rows = protocolFromRows(m_document.session());
  QAction* own = m_menu->addAction(tr("From the Rows"));
  own->setEnabled(!rows.positions.empty());
  connect(own, &QAction::triggered, this, [this, rows] { follow(rows); });
  const std::vector<Measure> advice = adviceOf(gapOfThis());
  const SightingProtocol both = advice.empty() ? SightingProtocol() : withMeasures(rows, advice);
  const bool isAdvised = !both.positions.empty();
  QAction* advised = m_menu->addAction(isAdvised ? tr("From the Rows and %1").arg(qText(textOf(advice)))
                                                 : tr("From the Rows and the Advice"));
  advised->setEnabled(isAdvised);
  if (isAdvised) connect(advised, &QAction::triggered, this, [this, both] { follow(both); });
  m_menu->addSeparator();
  const Guide* guide = guideThatLeads();
  QAction* byWorth = m_menu->addAction(tr("Most Informative Next"));
  byWorth->setToolTip(
      tr("The next sighting is the one with the most information per minute, not the first remaining one"));
  byWorth->setCheckable(true);
  byWorth->setEnabled(guide);
  byWorth->setChecked(guide && guide->protocol.isByWorth);
  connect(byWorth, &QAction::triggered, this, [this](bool isChecked) {
    const SightingProtocol& protocol = m_evaluation->guide->protocol;
    follow(isChecked ? openOrder(protocol) : listedOrder(protocol));
  });
  connect(m_menu->addAction(tr("Edit…")), &QAction::triggered, this, &OrderPanel::editWanted);
  connect(m_menu->addAction(tr("From a File…")), &QAction::triggered, this, &OrderPanel::loadWanted);
  const bool isFollowing = !m_document.session().protocol.empty();
  QAction* save = m_menu->addAction(tr("Save as a File…"));
  save->setEnabled(isFollowing);
  connect(save, &QAction::triggered, this, &OrderPanel::saveWanted);
  QAction* none = m_menu->addAction(tr("None"));
  none->setEnabled(isFollowing);
  connect(none, &QAction::triggered, this, [this] { follow(std::nullopt); });
}

void OrderPanel::follow(const std::optional<SightingProtocol>& protocol) {
  emit commitWanted();
  followProtocol(m_document, protocol);
}

}  // namespace alidade::ui

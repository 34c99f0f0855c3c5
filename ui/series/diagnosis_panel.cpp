#include "ui/series/diagnosis_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/wording/series_words.h"
#include "core/wording/verdict.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/frames.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QTableWidgetItem* textCell(const QString& text, bool isNumber = false) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  item->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  item->setToolTip(tipText(text));
  return item;
}

QString headlineOf(DiagnosisVerdict verdict, const std::vector<Cause>& causes) {
  Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  diagnosis.causes = causes;
  return gapHeadline(diagnosis);
}

QString sizesText(const Cause& cause) {
  QStringList sizes;
  for (const CauseParameter& parameter : cause.parameters) sizes << parameterText(cause, parameter);
  return listText(sizes);
}

}  // namespace

DiagnosisPanel::DiagnosisPanel(QWidget* parent)
    : QWidget(parent),
      m_sentence(wrappedLabel()),
      m_gap(wrappedLabel()),
      m_advice(wrappedLabel()),
      m_offers(new QWidget),
      m_causes(table({tr("Cause"), tr("Owner"), tr("Size"), tr("Probability"), tr("In one session (σ)"),
                      tr("In all (σ)"), tr("Look-alikes")},
                     tr("What the sessions share"))),
      m_sessions(table(
          {tr("Session"), tr("Date"), tr("Instrument"), tr("Device"), tr("Alone"), tr("Within the series")},
          tr("Each session alone and within the series"))) {
  auto* text = new QWidget;
  auto* column = new QVBoxLayout(text);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_sentence);
  column->addWidget(m_offers);
  column->addWidget(m_gap);
  column->addWidget(m_advice);
  column->addStretch();
  auto* offers = new QVBoxLayout(m_offers);
  offers->setContentsMargins(0, 0, 0, 0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(scrolled(text), 1);
  layout->addWidget(split(Qt::Vertical, "shared causes", {m_causes, m_sessions}, {90, 230}), 3);
  connect(m_sessions, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
    const auto row = static_cast<std::size_t>(item->row());
    if (m_diagnosis && row < m_diagnosis->sessions.size())
      emit sessionWanted(m_diagnosis->sessions[row].file);
  });
  setDiagnosis(nullptr);
}

QTableWidget* DiagnosisPanel::table(const QStringList& titles, const QString& name) {
  auto* table = new QTableWidget;
  table->setColumnCount(static_cast<int>(titles.size()));
  table->setHorizontalHeaderLabels(titles);
  table->setAccessibleName(name);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->setAlternatingRowColors(true);
  table->setWordWrap(false);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setStretchLastSection(true);
  return table;
}

void DiagnosisPanel::setDiagnosis(const SharedSeriesDiagnosis& diagnosis, const QString& reason) {
  m_diagnosis = diagnosis;
  m_causes->setRowCount(0);
  m_sessions->setRowCount(0);
  m_gap->clear();
  m_advice->clear();
  showOffers();
  if (!m_diagnosis) {
    m_sentence->setText(reason.isEmpty() ? tr("No sessions yet.") : reason);
    return;
  }
  m_sentence->setText(visibleLine(sentenceOf(*m_diagnosis)));
  if (!m_diagnosis->causes.empty() && !std::isnan(m_diagnosis->after.reducedChiSquare))
    m_gap->setText(
        tr("Reduced χ² of all sessions changes from %1 to %2; residuals of held-out sessions shrink by %3 %.")
            .arg(qText(displayText(m_diagnosis->gap.reducedChiSquare, 2)),
                 qText(displayText(m_diagnosis->after.reducedChiSquare, 2)),
                 qText(displayText(100 * m_diagnosis->shrink.heldOut, 1))));
  showCauses();
  showSessions();
  showAdvice();
}

void DiagnosisPanel::showCauses() {
  m_causes->setRowCount(static_cast<int>(m_diagnosis->causes.size()));
  for (int row = 0; row < m_causes->rowCount(); ++row) {
    const SharedCause& cause = m_diagnosis->causes[static_cast<std::size_t>(row)];
    const bool isOfOne = cause.owner == CauseOwner::Time && cause.sessions.size() == 1;
    const QString owner =
        visibleLine(isOfOne ? m_diagnosis->sessions[cause.sessions.front()].name : ownerText(cause));
    const bool shows = cause.visibleTogether > 0;
    const QString none = QStringLiteral("—");
    m_causes->setItem(row, 0, textCell(causeTitle(cause.cause.effect)));
    m_causes->setItem(row, 1, textCell(owner));
    m_causes->setItem(
        row, 2,
        textCell(cause.isDrifting ? tr("%1, changing between sessions").arg(sizesText(cause.cause))
                                  : sizesText(cause.cause)));
    m_causes->setItem(row, 3, textCell(qText(shortProbabilityText(cause.cause.probability)), true));
    m_causes->setItem(row, 4, textCell(shows ? qText(displayText(cause.visibleInOne, 1)) : none, true));
    m_causes->setItem(row, 5, textCell(shows ? qText(displayText(cause.visibleTogether, 1)) : none, true));
    m_causes->setItem(row, 6, textCell(causeNames(cause.cause.indistinguishableFrom, tr(" or "))));
  }
  m_causes->resizeColumnsToContents();
}

void DiagnosisPanel::showSessions() {
  m_sessions->setRowCount(static_cast<int>(m_diagnosis->sessions.size()));
  for (int row = 0; row < m_sessions->rowCount(); ++row) {
    const SeriesMember& member = m_diagnosis->sessions[static_cast<std::size_t>(row)];
    m_sessions->setItem(row, 0, textCell(visibleLine(member.name)));
    m_sessions->setItem(row, 1, textCell(visibleLine(member.measuredOn)));
    m_sessions->setItem(row, 2, textCell(visibleLine(member.instrument)));
    m_sessions->setItem(row, 3, textCell(visibleLine(member.guideway)));
    m_sessions->setItem(row, 4, textCell(headlineOf(member.alone, member.causesAlone)));
    m_sessions->setItem(row, 5, textCell(gapHeadline(member.diagnosis)));
  }
  m_sessions->resizeColumnsToContents();
}

void DiagnosisPanel::showOffers() {
  qDeleteAll(m_offers->findChildren<QPushButton*>());
  m_offers->setVisible(m_diagnosis && !m_diagnosis->offered.empty());
  if (!m_diagnosis) return;
  for (const OfferedEffect& offered : m_diagnosis->offered) {
    auto* button = new QPushButton(tr("Keep “%1” as an Effect…").arg(visibleLine(offered.effect.name)));
    button->setAutoDefault(false);
    button->setToolTip(tr("Writes an effect of your own, for this device or instrument, into a file"));
    connect(button, &QPushButton::clicked, this,
            [this, effect = offered.effect] { emit keepWanted(effect); });
    m_offers->layout()->addWidget(button);
    m_offers->layout()->setAlignment(button, Qt::AlignLeft);
  }
}

void DiagnosisPanel::showAdvice() {
  QStringList lines;
  for (const SeriesAdvice& advice : m_diagnosis->advice) lines << visibleLine(sentenceOf(advice));
  for (const Finding& finding : findingsOf(*m_diagnosis))
    lines << visibleLine(finding.text + " " + finding.remedy);
  m_advice->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace alidade::ui

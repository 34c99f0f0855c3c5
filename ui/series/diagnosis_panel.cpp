#include "ui/series/diagnosis_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/statement/gap.h"
#include "core/statement/series.h"
#include "core/wording/series_words.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

StatementTable* tableFor(const Statement& columns) {
  auto* table = new StatementTable(columns);
  table->setAccessibleName(qText(columns.title));
  return table;
}

}  // namespace

DiagnosisPanel::DiagnosisPanel(QWidget* parent)
    : QWidget(parent),
      m_sentence(wrappedLabel()),
      m_findings(wrappedLabel()),
      m_offers(new QWidget),
      m_stages(new StatementView),
      m_where(new StatementView),
      m_advice(new StatementView),
      m_undetectable(new StatementView),
      m_causes(tableFor(seriesCauses({}))),
      m_sessions(tableFor(seriesSessions({}))) {
  auto* text = new QWidget;
  auto* column = new QVBoxLayout(text);
  column->setContentsMargins(6, 0, 6, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_sentence, m_offers, m_findings, m_advice, m_stages,
                                                       m_where, m_undetectable})
    column->addWidget(part);
  column->addStretch();
  auto* offers = new QVBoxLayout(m_offers);
  offers->setContentsMargins(0, 0, 0, 0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  QSplitter* tables = split(Qt::Vertical, "shared causes", {m_causes, m_sessions}, {90, 230});
  QSplitter* parts = split(Qt::Horizontal, "shared parts", {tables, scrolled(text)}, {620, 360});
  parts->setStretchFactor(0, 1);
  layout->addWidget(parts);
  connect(m_sessions, &DataTable::rowActivated, this, [this](int row) {
    const auto index = static_cast<std::size_t>(row);
    if (m_diagnosis && index < m_diagnosis->sessions.size())
      emit sessionWanted(m_diagnosis->sessions[index].file);
  });
  setDiagnosis(nullptr);
}

void DiagnosisPanel::setDiagnosis(const SharedSeriesDiagnosis& diagnosis, const QString& reason) {
  m_diagnosis = diagnosis;
  showOffers();
  static const SeriesDiagnosis none;
  const SeriesDiagnosis& series = diagnosis ? *diagnosis : none;
  m_causes->setPlaceholder(diagnosis ? tr("The sessions share no cause.") : QString());
  m_causes->setStatement(seriesCauses(series));
  m_sessions->setStatement(seriesSessions(series));
  m_advice->setStatement(seriesAdvice(series));
  m_undetectable->setStatement(seriesUndetectable(series));
  const bool isExplained = !series.causes.empty() || series.pattern;
  m_stages->setStatement(isExplained ? std::optional(seriesStages(series)) : std::nullopt);
  m_where->setStatement(isExplained ? std::optional(gapWhere(series.where)) : std::nullopt);
  QStringList findings;
  for (const Finding& finding : findingsOf(series))
    findings << visibleLine(finding.text + " " + finding.remedy);
  m_findings->setText(findings.join(QLatin1Char('\n')));
  m_findings->setVisible(!findings.isEmpty());
  if (diagnosis)
    m_sentence->setText(visibleLine(sentenceOf(series)));
  else
    m_sentence->setText(reason.isEmpty() ? tr("No sessions yet.") : reason);
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

}  // namespace alidade::ui

#include "ui/panels/uncertainty/simulation_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "core/statement/budget.h"
#include "ui/document/session_document.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

constexpr int fewestDraws = 1000;

}  // namespace

SimulationBox::SimulationBox(const SessionDocument& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_draws(new QSpinBox),
      m_run(new QPushButton),
      m_progress(new QProgressBar),
      m_answer(new StatementView),
      m_note(wrappedLabel()) {
  createControls();
  auto* row = new QHBoxLayout;
  auto* caption = new QLabel(tr("Draws"));
  caption->setBuddy(m_draws);
  for (QWidget* part : std::initializer_list<QWidget*>{caption, m_draws, m_run}) row->addWidget(part);
  row->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(panelHeading(tr("Check by Monte Carlo")));
  layout->addLayout(row);
  layout->addWidget(m_progress);
  layout->addWidget(m_note);
  layout->addWidget(m_answer);
  connect(m_run, &QPushButton::clicked, this, &SimulationBox::toggle);
  connect(&m_job, &SimulationJob::finished, this, &SimulationBox::take);
  connect(&m_watch, &QTimer::timeout, this,
          [this] { m_progress->setValue(m_isWaiting ? 0 : static_cast<int>(m_job.drawsMade())); });
  hide();
  showWork();
}

void SimulationBox::createControls() {
  m_draws->setRange(0, static_cast<int>(mostDrawsLeftOpen));
  m_draws->setSpecialValueText(tr("as many as needed"));
  m_draws->setSingleStep(100000);
  m_draws->setToolTip(
      tr("More draws determine the ends of the interval better. With 0, the number of draws is just enough "
         "to decide whether the propagated uncertainty is correct"));
  m_run->setObjectName(QStringLiteral("run simulation"));
  m_run->setToolTip(
      tr("Draws every reading, pointing zero and length from its distribution and repeats the fit for each "
         "draw (JCGM 101)"));
  m_progress->setAccessibleName(tr("Draws made"));
  m_progress->setTextVisible(false);
  m_progress->setFixedHeight(8);
}

void SimulationBox::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  stopOutdated();
  const bool hasIntersection = evaluation->fit.intersection.has_value();
  setVisible(hasIntersection);
  if (!hasIntersection) m_isWaiting = false;
  if (m_isWaiting) start();
  showWork();
  showCheck();
}

void SimulationBox::stopOutdated() {
  if (!m_job.isAtWork() || measuresAlike(m_simulated->session, m_document.session())) return;
  m_remark = tr("Stopped, because the session has changed.");
  m_job.stop();
}

void SimulationBox::toggle() {
  if (isWanted()) {
    m_remark = tr("Stopped.");
    m_isWaiting = false;
    m_job.stop();
  } else {
    m_remark.clear();
    start();
  }
  showWork();
  showCheck();
}

/// Starts the run, or waits for the running fit if an edit changed the session after the last fit.
void SimulationBox::start() {
  m_isWaiting = !measuresAlike(m_evaluation->session, m_document.session());
  const int draws = m_draws->value() == 0 ? 0 : std::max(fewestDraws, m_draws->value());
  m_progress->setRange(0, draws);  // 0: busy, duration unknown
  m_progress->setValue(0);
  if (m_isWaiting) return;
  m_simulated = m_evaluation;
  m_job.start(m_simulated, static_cast<std::size_t>(draws));
}

void SimulationBox::take(const SharedBudgetCheck& check) {
  if (check->simulated) {
    m_check = check;
    m_remark.clear();
    emit checked(check);
  } else if (!check->failure.empty()) {
    m_remark = qText(check->failure);
  } else if (m_remark.isEmpty()) {
    m_remark = tr("Too few of the draws gave a result.");
  }
  showWork();
  showCheck();
}

void SimulationBox::showWork() {
  const bool isAtWork = isWanted();
  m_run->setText(isAtWork ? tr("Stop") : tr("Run"));
  m_draws->setEnabled(!isAtWork);
  m_progress->setVisible(isAtWork);
  isAtWork ? m_watch.start(100) : m_watch.stop();
}

void SimulationBox::showCheck() {
  const auto& linear = m_evaluation ? m_evaluation->fit.intersection : std::nullopt;
  const bool isAnswered = !isWanted() && m_check && linear && m_check->isOf(m_evaluation->session);
  std::optional<Statement> statement;
  if (isAnswered) statement = monteCarloCheck(*m_check->simulated, &*linear);
  if (statement) statement->title.clear();
  m_answer->setStatement(statement);
  m_note->setText(!m_remark.isEmpty() || isAnswered
                      ? m_remark
                      : tr("The propagated uncertainty has not been checked yet."));
  m_note->setVisible(!isWanted() && !m_note->text().isEmpty());
}

}  // namespace alidade::ui

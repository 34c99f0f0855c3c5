#include "ui/dialogs/blind_trial_dialog.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>
#include <QVBoxLayout>
#include <initializer_list>

#include "core/simulation/protocol.h"
#include "core/statement/gap.h"
#include "core/wording/guidance.h"
#include "ui/dialogs/trial_list.h"
#include "ui/panels/gap/gap_headline.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/trial_text.h"

namespace alidade::ui {

namespace {

QLabel* textOfLines(int lines) {
  QLabel* label = wrappedLabel();
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  layOutByFont(*label,
               [label, lines] { label->setMinimumHeight(lines * label->fontMetrics().lineSpacing()); });
  return label;
}

}  // namespace

BlindTrialDialog::BlindTrialDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Blind Trial"));
  auto* head = new QHBoxLayout;
  head->addWidget(createChoices(), 0);
  head->addWidget(createAnswer(), 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(createTruth(), 1);
  foot->addWidget(createTrials(), 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(head);
  layout->addLayout(foot, 1);
  layout->addWidget(createButtons());
  resize(900, 620);
  connect(&m_job, &TrialJob::diagnosed, this, &BlindTrialDialog::take);
  showTrial(nullptr);
}

QWidget* BlindTrialDialog::createChoices() {
  m_plan = new QComboBox;
  m_plan->addItem(tr("any plan"), QString());
  for (const Protocol& protocol : namedProtocols()) {
    m_plan->addItem(qText(protocolInWords(templateOf(protocol))), qText(protocol.name));
  }
  m_kind = new QComboBox;
  m_kind->addItem(tr("any error, or none"), QString());
  for (const TrialKind& kind : trialKinds()) m_kind->addItem(trialKindName(kind.name), qText(kind.name));
  m_visible = new QComboBox;
  m_visible->addItem(tr("clearly, at 6 to 25 σ"), QPointF(6, 25));
  m_visible->addItem(tr("faintly, at 2 to 6 σ"), QPointF(2, 6));
  m_seed = new QSpinBox;
  m_seed->setRange(1, 999999);
  m_seed->setValue(QRandomGenerator::global()->bounded(1, 900000));
  m_seed->setToolTip(
      tr("The same number and choices give the same trial; each draw increases the number by one"));
  m_choices = new QWidget;
  auto* form = new QFormLayout(m_choices);
  form->setContentsMargins(0, 0, 12, 0);
  form->addRow(panelHeading(tr("Trial to draw")));
  form->addRow(tr("&Plan"), m_plan);
  form->addRow(tr("&Truth"), m_kind);
  form->addRow(tr("S&hows"), m_visible);
  form->addRow(tr("&Number"), m_seed);
  return m_choices;
}

QWidget* BlindTrialDialog::createAnswer() {
  m_title = panelHeading({});
  m_answer = new GapHeadline;
  layOutByFont(*m_answer, [this] { m_answer->setMinimumHeight(5 * fontMetrics().lineSpacing()); });
  m_stages = new StatementView;
  auto* answer = new QWidget;
  auto* layout = new QVBoxLayout(answer);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_title, m_answer, m_stages}) layout->addWidget(part);
  layout->addStretch();
  return answer;
}

QWidget* BlindTrialDialog::createTruth() {
  m_truth = textOfLines(5);
  m_score = textOfLines(2);
  QFont bold = font();
  bold.setBold(true);
  m_score->setFont(bold);
  auto* truth = new QWidget;
  auto* layout = new QVBoxLayout(truth);
  layout->setContentsMargins(0, 0, 12, 0);
  layout->addWidget(panelHeading(tr("Truth")));
  layout->addWidget(m_score);
  layout->addWidget(m_truth);
  layout->addStretch();
  return truth;
}

QWidget* BlindTrialDialog::createTrials() {
  m_trials = new TrialList;
  connect(m_trials, &TrialList::chosen, this, [this](const SharedTrial& trial) {
    if (trial != m_current) showTrial(trial);
  });
  return m_trials;
}

QWidget* BlindTrialDialog::createButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 6, 0, 0);
  const auto add = [&](const QString& text, const char* name) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    layout->addWidget(button);
    return button;
  };
  m_draw = add(tr("&Draw a trial"), "draw");
  m_open = add(tr("&Open the seal"), "open seal");
  m_inWindow = add(tr("Sho&w in main window"), "in window");
  m_inWindow->setToolTip(tr("Opens the session of the trial as a new session; its truth stays sealed"));
  layout->addStretch();
  m_count = new QSpinBox;
  m_count->setRange(2, 10000);
  m_count->setValue(50);
  m_count->setAccessibleName(tr("Number of trials in one run"));
  m_series = add({}, "series");
  layout->addWidget(m_count);
  m_progress = new QProgressBar;
  m_progress->setFixedWidth(120);
  layout->addWidget(m_progress);
  auto* close = add(tr("&Close"), "close");
  m_draw->setDefault(true);
  connect(m_draw, &QPushButton::clicked, this, [this] { draw(1); });
  connect(m_open, &QPushButton::clicked, this, &BlindTrialDialog::openSeal);
  connect(m_inWindow, &QPushButton::clicked, this, [this] { emit sessionWanted(m_current->trial.session); });
  connect(m_series, &QPushButton::clicked, this, [this] {
    if (!m_job.isAtWork()) return draw(m_count->value());
    m_job.stop();
    showWork();
  });
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return row;
}

BlindTrialOptions BlindTrialDialog::options() const {
  BlindTrialOptions options;
  options.protocol = m_plan->currentData().toString().toStdString();
  const QPointF visible = m_visible->currentData().toPointF();
  options.leastVisible = visible.x();
  options.mostVisible = visible.y();
  const std::string kind = m_kind->currentData().toString().toStdString();
  if (!kind.empty()) options.kinds = {kind};
  return options;
}

void BlindTrialDialog::draw(int count) {
  m_isSeries = count > 1;
  m_progress->setRange(0, count);
  m_progress->setValue(0);
  m_trials->beginDraw(m_isSeries);
  m_job.start(options(), static_cast<std::uint64_t>(m_seed->value()), count);
  showWork();
}

/// Adds the trial to the list. A trial without a result stops the draw; its problem is shown instead.
void BlindTrialDialog::take(const SharedTrial& trial) {
  m_seed->setValue(m_seed->value() % m_seed->maximum() + 1);
  m_progress->setValue(m_progress->value() + 1);
  if (trial->problem.empty()) {
    m_trials->add(trial);
  } else {
    m_job.stop();
    m_trials->clearChoice();
    showTrial(trial);
  }
  showWork();
  if (!m_isSeries && m_current == trial) m_open->setFocus();
}

void BlindTrialDialog::openSeal() {
  m_trials->openSeal(m_current);
  showTrial(m_current);
  m_draw->setFocus();
}

void BlindTrialDialog::showTrial(const SharedTrial& trial) {
  m_current = trial;
  m_isOpen = trial && m_trials->isOpen(trial);
  const bool says = trial && trial->problem.empty();
  m_title->setText(!says ? tr("Diagnosis")
                         : tr("Diagnosis of trial %1, plan %2")
                               .arg(qText(trial->trial.seal.id), qText(trial->trial.truth.protocol)));
  if (says)
    m_answer->setGap(trial->gap);
  else
    m_answer->setText(tr("No trial drawn yet"),
                      trial ? qText(trial->problem)
                            : tr("A session is simulated from hidden true values, following the plan. The "
                                 "diagnosis knows only the readings; then you open the seal."));
  m_stages->setStatement(says ? std::optional(gapStages(trial->gap)) : std::nullopt);
  showTruth();
  showWork();
}

void BlindTrialDialog::showTruth() {
  const bool says = m_current && m_current->problem.empty();
  m_score->setVisible(m_isOpen);
  if (m_isOpen) {
    m_truth->setText(truthLines(m_current->trial).join(u'\n'));
    m_score->setText((m_current->score.right ? tr("Right. ") : tr("Wrong. ")) +
                     scoreSentence(m_current->trial.seal, m_current->score));
  } else {
    m_truth->setText(says ? tr("Sealed. The diagnosis is complete: open the seal to see what was simulated.")
                          : QString());
  }
  colorScore();
}

/// Every draw locks the number of the trial; a series also locks the choices and the number of trials.
void BlindTrialDialog::showWork() {
  const bool isAtWork = m_job.isAtWork(), isStretch = isAtWork && m_isSeries;
  const bool isDrawn = m_current && m_current->problem.empty();
  m_choices->setEnabled(!isStretch);
  m_seed->setReadOnly(isAtWork);
  m_count->setEnabled(!isStretch);
  m_draw->setEnabled(!isAtWork);
  m_open->setEnabled(isDrawn && !m_isOpen);
  m_inWindow->setEnabled(!isAtWork && isDrawn);
  m_series->setText(isStretch ? tr("&Stop") : tr("Dr&aw many, open all:"));
  m_series->setEnabled(!isAtWork || m_isSeries);
  m_progress->setVisible(isStretch);
}

void BlindTrialDialog::colorScore() {
  QPalette colored = palette();
  const bool isRight = m_isOpen && m_current->score.right;
  colored.setColor(QPalette::WindowText, stateColor(palette(), isRight ? State::Good : State::Bad));
  m_score->setPalette(colored);
}

void BlindTrialDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorScore();
}

}  // namespace alidade::ui

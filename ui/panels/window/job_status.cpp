#include "ui/panels/window/job_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <initializer_list>

#include "ui/jobs/fit_job.h"
#include "ui/jobs/gap_job.h"

namespace alidade::ui {

namespace {

constexpr int lookEvery = 200;  // polling interval, ms
constexpr int patience = 2;     // number of polls before anything is shown

}  // namespace

JobStatus::JobStatus(const FitJob& fit, const GapJob& gap, QWidget* parent)
    : QWidget(parent), m_fit(fit), m_gap(gap), m_text(new QLabel), m_stop(new QToolButton) {
  auto* bar = new QProgressBar;
  bar->setRange(0, 0);
  bar->setTextVisible(false);
  bar->setFixedSize(80, 10);
  m_stop->setText(tr("Stop"));
  m_stop->setObjectName(QStringLiteral("stop jobs"));
  m_stop->setToolTip(tr("Stops and keeps the result of the fit; the next edit restarts all calculations"));
  m_stop->setAutoRaise(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 6, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_text, bar, m_stop}) layout->addWidget(part);
  connect(m_stop, &QToolButton::clicked, this, &JobStatus::stopWanted);
  connect(&m_watch, &QTimer::timeout, this, &JobStatus::look);
  hide();
}

void JobStatus::watch() {
  if (!m_watch.isActive()) m_watch.start(lookEvery);
}

void JobStatus::look() {
  const QString text = doing();
  m_looks = text.isEmpty() ? 0 : m_looks + 1;
  if (text.isEmpty() && m_gap.isIdle()) m_watch.stop();
  m_text->setText(text);
  m_stop->setEnabled(!m_fit.isFitting());
  setVisible(m_looks > patience);
}

QString JobStatus::doing() const {
  if (m_fit.isFitting()) return tr("Fitting…");
  if (m_gap.isAtWork() && !m_gap.isIdle()) return tr("Diagnosing…");
  return m_fit.isSearching() ? tr("Looking for misread readings…") : QString();
}

}  // namespace alidade::ui

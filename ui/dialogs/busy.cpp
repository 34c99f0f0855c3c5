#include "ui/dialogs/busy.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFutureWatcher>
#include <QProgressDialog>
#include <QTimer>

namespace alidade::ui {

namespace {

constexpr int moment = 400, breath = 30, fine = 1000;  // ms, ms, steps of the bar

}  // namespace

Busy::Busy(QWidget* parent, const QString& doing, Way way) : m_parent(parent), m_doing(doing), m_way(way) {
  m_since.start();
  m_breath.start();
}

Busy::~Busy() = default;

void Busy::showDialog() {
  if (m_dialog) return;
  const QString stop = m_way == Way::Stoppable ? QCoreApplication::translate("Busy", "Stop")
                                               : QString();  // an empty text: no button
  m_dialog = std::make_unique<QProgressDialog>(m_doing, stop, 0, 0, m_parent);
  m_dialog->setWindowTitle(QCoreApplication::applicationName());
  m_dialog->setWindowModality(Qt::ApplicationModal);
  m_dialog->setAutoReset(false);
  m_dialog->setAutoClose(false);
  m_dialog->setMinimumDuration(0);
  m_dialog->show();
}

/// Input waits until the work ends, or until the dialog of a stoppable operation opens. The dialog is modal,
/// so it blocks all other input.
bool Busy::waitFor(const QFuture<void>& work) {
  QFutureWatcher<void> watcher;
  QEventLoop loop;
  QObject::connect(&watcher, &QFutureWatcherBase::finished, &loop, &QEventLoop::quit);
  watcher.setFuture(work);
  if (work.isFinished()) return true;
  QTimer::singleShot(moment, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  if (work.isFinished()) return true;
  showDialog();
  if (m_way == Way::Stoppable) {
    QObject::connect(m_dialog.get(), &QProgressDialog::canceled, &loop, &QEventLoop::quit);
    loop.exec();
  } else {
    loop.exec(QEventLoop::ExcludeUserInputEvents);
  }
  return work.isFinished();
}

bool Busy::goesOn(double done) {
  if (m_breath.elapsed() >= breath) {
    if (m_since.elapsed() >= moment) showDialog();
    if (m_dialog) {
      m_dialog->setMaximum(fine);
      m_dialog->setValue(static_cast<int>(done * fine));
    }
    QCoreApplication::processEvents(m_dialog ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents);
    m_breath.restart();
  }
  return !m_dialog || !m_dialog->wasCanceled();
}

}  // namespace alidade::ui

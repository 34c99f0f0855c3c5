#include "ui/document/disposal.h"

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>

namespace alidade::ui {

void doAside(std::function<void()> work) {
  const QCoreApplication* application = QCoreApplication::instance();
  if (!application || QThread::currentThread() != application->thread()) return work();
  QThreadPool::globalInstance()->start(std::move(work));
}

}  // namespace alidade::ui

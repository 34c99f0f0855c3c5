#include "ui/document/disposal.h"

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace alidade::ui {

void doAside(std::function<void()> work) {
  const QCoreApplication* application = QCoreApplication::instance();
  if (!application || QThread::currentThread() != application->thread()) return work();
  QThreadPool::globalInstance()->start(std::move(work));
}

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // the largest allowed value
  mallopt(M_TRIM_THRESHOLD, 256 * mebibyte);
#endif
}

}  // namespace alidade::ui

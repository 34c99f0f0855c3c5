#include "tests/ui/monkey/housekeeper.h"

#include <QApplication>
#include <QTest>

namespace alidade::ui {

namespace {

QWidget* waiting() {
  QWidget* popup = QApplication::activePopupWidget();
  return popup ? popup : QApplication::activeModalWidget();
}

}  // namespace

Housekeeper::Housekeeper(unsigned seed) : m_chance(seed) {
  QObject::connect(&m_timer, &QTimer::timeout, [this] { look(); });
  m_timer.start(5);
}

bool Housekeeper::isBusy() {
  return waiting() != nullptr;
}

/// Keys and closing act after this call, since either may open another dialog that waits.
void Housekeeper::look() {
  QWidget* open = waiting();
  if (!open) {
    m_patience = m_chance.between(1, 5);
  } else if (m_patience-- > 0) {
    constexpr Qt::Key keys[] = {Qt::Key_Down, Qt::Key_Up, Qt::Key_Return, Qt::Key_Right, Qt::Key_Escape};
    QTimer::singleShot(0, open, [open, key = m_chance.of(keys)] { QTest::keyClick(open, key); });
  } else {
    QTimer::singleShot(0, open, &QWidget::close);
  }
}

}  // namespace alidade::ui

#include "ui/models/next_entry.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVariant>
#include <QWidget>

namespace alidade::ui {

namespace {

constexpr const char* passedOver = "passed over by Enter";

bool isEntry(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const QAbstractItemView*>(widget);
}

}  // namespace

QWidget* nextEntry(const QWidget* entry) {
  const QWidget* window = entry->window();
  for (QWidget* next = entry->nextInFocusChain(); next && next != entry; next = next->nextInFocusChain()) {
    const bool isReached = next->window() == window && next->isVisibleTo(window) && next->isEnabled() &&
                           (next->focusPolicy() & Qt::TabFocus) != 0;
    if (isReached && isEntry(next) && !next->property(passedOver).toBool()) return next;
  }
  return nullptr;
}

void passOver(QWidget* entry) {
  entry->setProperty(passedOver, true);
}

}  // namespace alidade::ui

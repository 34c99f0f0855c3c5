#include "ui/application.h"

#include "core/base/failure.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (...) {
    const std::string reason = thrownReason();
    failureOf([&] { report(qText(reason)); });
    return false;
  }
}

bool Application::event(QEvent* event) {
  const bool isKnown = QApplication::event(event);
  if (event->type() == QEvent::ApplicationFontChange) emit FontNews::of().changed();
  return isKnown;
}

/// Emits `failed` once per reason, after the event: a dialog must not open inside the failed handler.
void Application::report(const QString& reason) {
  if (m_reported.contains(reason)) return;
  m_reported.insert(reason);
  QMetaObject::invokeMethod(
      this, [this, reason] { emit failed(reason); }, Qt::QueuedConnection);
}

}  // namespace alidade::ui

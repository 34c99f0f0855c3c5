#pragma once

#include <QObject>
#include <QString>

#include "core/base/angle_text.h"
#include "core/base/problem.h"

namespace alidade::ui {

class SessionDocument;

/// Connects an input widget, its parent, to one field of the session. The widget shows `text()` at every
/// `refreshed`, and passes entries to `enter`, which uses the undo stack.
class FieldBinding : public QObject {
  Q_OBJECT

 public:
  FieldBinding(SessionDocument& document, Place place, QWidget* widget);

  const Place& place() const { return m_place; }
  QWidget* widget() const;
  QString text() const;     ///< as typed
  QString problem() const;  ///< why the text is unusable; empty if usable or absent
  void enter(const QString& text);
  void noteTyped(const QString& text);  ///< the text that committing now would enter
  void noteTypingEnded();
  CircleUnit angleUnit() const;  ///< of the session

 signals:
  void refreshed();
  void commitWanted();  ///< unfinished entries must be committed now, before the session is used

 private:
  SessionDocument& m_document;
  Place m_place;
};

}  // namespace alidade::ui

#pragma once

#include <QObject>
#include <QString>

#include "core/base/circle_unit.h"
#include "core/base/place.h"

namespace alidade::ui {

class SessionDocument;

/// Ties an input widget, its parent, to one field of the session. The widget shows `text()` whenever
/// `refreshed`, and hands in what was entered with `enter`, which goes through the undo stack.
class FieldBinding : public QObject {
  Q_OBJECT

 public:
  FieldBinding(SessionDocument& document, Place place, QWidget* widget);

  const Place& place() const { return m_place; }
  QWidget* widget() const;
  QString text() const;     ///< as typed
  QString problem() const;  ///< why the text cannot be used; empty where it can, or where there is none
  void enter(const QString& text);
  void noteTyped(const QString& text);  ///< that would be entered, were it handed in now
  void noteTypingEnded();
  CircleUnit angleUnit() const;  ///< of the session

 signals:
  void refreshed();
  void commitWanted();  ///< what is half typed is to be handed in now: the session is about to be used

 private:
  SessionDocument& m_document;
  Place m_place;
};

}  // namespace alidade::ui

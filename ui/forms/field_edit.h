#pragma once

#include <QLineEdit>

#include "core/base/problem.h"

class QAction;

namespace alidade::ui {

class FieldBinding;
class SessionDocument;

/// A line that edits one field. Enter commits and moves to the next entry; leaving the field commits; Escape
/// cancels an unfinished entry. An unusable entry stays, with a frame, a mark and the reason as tool tip.
class FieldEdit : public QLineEdit {
  Q_OBJECT

 public:
  enum class Shows { AsTyped, Angle };  ///< Angle: normalised while the field is not being edited

  FieldEdit(SessionDocument& document, const Place& place, Shows shows = Shows::AsTyped,
            QWidget* parent = nullptr);

  bool hasProblem() const { return !m_problem.isEmpty(); }
  const QString& problem() const { return m_problem; }
  void setHint(const QString& hint);  ///< the tool tip while there is no problem

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void commit();
  QString entered() const;
  void refresh();
  QString tip(const QString& typed) const;

  FieldBinding* m_binding;
  Shows m_shows;
  QAction* m_mark;
  QString m_problem, m_hint;
};

}  // namespace alidade::ui

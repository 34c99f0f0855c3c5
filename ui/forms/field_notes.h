#pragma once

#include <QPlainTextEdit>

#include "core/base/problem.h"

namespace alidade::ui {

class FieldBinding;
class SessionDocument;

/// Several lines of free text for one field, committed when the focus leaves.
class FieldNotes : public QPlainTextEdit {
  Q_OBJECT

 public:
  FieldNotes(SessionDocument& document, const Place& place, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void commit();
  void refresh();
  QString typed() const;

  FieldBinding* m_binding;
};

}  // namespace alidade::ui

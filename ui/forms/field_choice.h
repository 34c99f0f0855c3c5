#pragma once

#include <QComboBox>
#include <QVector>

#include "core/base/problem.h"

namespace alidade::ui {

class FieldBinding;
class SessionDocument;

/// One of a field's possible texts with its label. A field without text shows the first choice.
struct Choice {
  QString text, caption;
};

/// A list that edits one field. An unknown text of the file is listed as it is, with its problem as tool tip.
class FieldChoice : public QComboBox {
  Q_OBJECT

 public:
  FieldChoice(SessionDocument& document, const Place& place, const QVector<Choice>& choices,
              QWidget* parent = nullptr);

  void setHint(const QString& hint);

 protected:
  void keyPressEvent(QKeyEvent* event) override;  ///< Enter moves to the next entry
  void wheelEvent(QWheelEvent* event) override;   ///< scrolls the form; never changes the choice

 private:
  void refresh();

  FieldBinding* m_binding;
  int m_choices;
  QString m_hint;
};

}  // namespace alidade::ui

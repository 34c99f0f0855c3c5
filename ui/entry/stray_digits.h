#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace alidade::ui {

/// Reports a digit typed while the focused widget accepts no text (a button, a picture or a table of
/// figures), so that the digit can be forwarded.
class StrayDigits : public QObject {
  Q_OBJECT

 public:
  explicit StrayDigits(QWidget& window);

 signals:
  void typed(QKeyEvent* event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& m_window;
  bool m_isForwarding = false;
};

}  // namespace alidade::ui

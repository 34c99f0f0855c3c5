#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace alidade::ui {

/// Digits typed in a window where nothing takes them, on a button, a picture or a table of figures: they are
/// told of, so that they can be led to where they belong.
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
  bool m_isTold = false;  ///< one is being led to where it belongs
};

}  // namespace alidade::ui

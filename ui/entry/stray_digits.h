#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace alidade::ui {

/// Reports digits typed where nothing takes them (a button, a picture or a table of figures), so that they
/// can be forwarded.
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
  bool m_isForwarding = false;  ///< a digit is being forwarded
};

}  // namespace alidade::ui

#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace alidade::ui {

/// A bar at the top saying that another program changed or removed the session's file; hidden otherwise.
class ChangedFileBar : public QFrame {
  Q_OBJECT

 public:
  explicit ChangedFileBar(QWidget* parent = nullptr);

  void showChanged(const QString& name);  ///< `name` of the file
  void showMissing(const QString& name);

 signals:
  void comparisonWanted();
  void saveWanted();

 private:
  void showText(const QString& text, bool isMissing);

  QLabel* m_text;
  QPushButton *m_compare, *m_save, *m_hide;
};

}  // namespace alidade::ui

#pragma once

#include <QFrame>

class QLabel;

namespace alidade::ui {

/// A bar at the top saying that another program changed the session's file; hidden otherwise.
class ChangedFileBar : public QFrame {
  Q_OBJECT

 public:
  explicit ChangedFileBar(QWidget* parent = nullptr);

  void showFor(const QString& name);  ///< `name` of the file

 signals:
  void comparisonWanted();

 private:
  QLabel* m_text;
};

}  // namespace alidade::ui

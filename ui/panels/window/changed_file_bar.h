#pragma once

#include <QFrame>

class QLabel;

namespace alidade::ui {

/// Says above everything that others wrote the session's file. Hidden where nobody did.
class ChangedFileBar : public QFrame {
  Q_OBJECT

 public:
  explicit ChangedFileBar(QWidget* parent = nullptr);

  void tellOf(const QString& name);  ///< of the file

 signals:
  void comparisonWanted();

 private:
  QLabel* m_text;
};

}  // namespace alidade::ui

#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace alidade::ui {

class ReadingFlow;

/// A reading of the instrument that is not as expected: what was read, and what shall be done. Gone where
/// there is none. All goes on beside it.
class ReadingQuestionBar : public QFrame {
  Q_OBJECT

 public:
  explicit ReadingQuestionBar(ReadingFlow& flow, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showQuestion();

  ReadingFlow& m_flow;
  QLabel *m_icon, *m_text;
  QPushButton *m_take, *m_discard;
};

}  // namespace alidade::ui

#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace alidade::ui {

class ReadingFlow;

/// Asks whether to take an unexpected reading of the instrument. Non-modal; hidden without a question.
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

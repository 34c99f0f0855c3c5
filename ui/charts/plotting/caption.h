#pragma once

#include <QLabel>

namespace alidade::ui {

/// A sentence on one line, in small letters, that takes no more width than there is: what does not fit ends
/// in an ellipsis and stands whole in the tool tip and for screen readers.
class Caption : public QLabel {
  Q_OBJECT

 public:
  explicit Caption(QWidget* parent = nullptr);

  void setSentence(const QString& sentence);
  QString sentence() const { return m_sentence; }

  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }
  QSize sizeHint() const override { return {0, QLabel::sizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();

  QString m_sentence;
};

}  // namespace alidade::ui

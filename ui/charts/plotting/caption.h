#pragma once

#include <QLabel>

namespace alidade::ui {

/// A sentence in small letters, on two lines where one is too short for it. It takes no more width than there
/// is: what does not fit ends in an ellipsis and stands whole in the tool tip and for screen readers.
class Caption : public QLabel {
  Q_OBJECT

 public:
  explicit Caption(QWidget* parent = nullptr);

  void setSentence(const QString& sentence);
  QString sentence() const { return m_sentence; }
  /// Over a second line; at first it may.
  void setMaySpread(bool may);

  QSize minimumSizeHint() const override { return {0, heightOf(1)}; }
  QSize sizeHint() const override { return minimumSizeHint(); }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  int heightOf(int lines) const;
  int room(int width) const;
  /// As it is shown in a width, the lines parted by line ends.
  QString fitted(int width) const;
  void fit();

  QString m_sentence;
  bool m_maySpread = true;
};

}  // namespace alidade::ui

#pragma once

#include <QLabel>

namespace alidade::ui {

/// A sentence in small type, on two lines if one line is too short. The caption never widens its parent: an
/// ellipsis shortens the sentence, while the tool tip and screen readers give the whole sentence.
class Caption : public QLabel {
  Q_OBJECT

 public:
  explicit Caption(QWidget* parent = nullptr);

  void setSentence(const QString& sentence);
  QString sentence() const { return m_sentence; }
  /// Whether the sentence may use a second line; true at first.
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
  /// The text as shown in a width, lines separated by line ends.
  QString fitted(int width) const;
  void fit();

  QString m_sentence;
  bool m_maySpread = true;
};

}  // namespace alidade::ui

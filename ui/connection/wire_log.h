#pragma once

#include <QPlainTextEdit>

namespace alidade::ui {

/// What went over the wire and what was said of it, line by line with its time: → sent, ← received, · said.
class WireLog : public QPlainTextEdit {
  Q_OBJECT

 public:
  /// The oldest go beyond that: two lines a second for a working day.
  static constexpr int mostLines = 50'000;

  explicit WireLog(QWidget* parent = nullptr);

  void addLine(bool isSent, const QString& shown);
  void addRemark(const QString& sentence);
  /// As a file.
  std::string bytes() const;

 private:
  void add(QChar sign, const QString& text);
};

}  // namespace alidade::ui

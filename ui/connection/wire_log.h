#pragma once

#include <QPlainTextEdit>

namespace alidade::ui {

/// The communication and its events, line by line with the time: → sent, ← received, · events.
class WireLog : public QPlainTextEdit {
  Q_OBJECT

 public:
  /// The log drops the oldest lines beyond this number, enough for two lines a second on a working day.
  static constexpr int mostLines = 50'000;

  explicit WireLog(QWidget* parent = nullptr);

  void addLine(bool isSent, const QString& shown);
  void addRemark(const QString& sentence);
  /// The log as the bytes of a text file.
  std::string bytes() const;

 private:
  void add(QChar sign, const QString& text);
};

}  // namespace alidade::ui

#pragma once

#include <QApplication>
#include <QSet>

namespace alidade::ui {

/// The application, which survives exceptions of its windows' event handlers.
class Application : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// Emitted after the event with the text of `thrownReason`, once per reason.
  void failed(const QString& reason);

 protected:
  bool event(QEvent* event) override;

 private:
  void report(const QString& reason);

  QSet<QString> m_reported;
};

}  // namespace alidade::ui

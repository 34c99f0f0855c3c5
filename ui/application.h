#pragma once

#include <QApplication>
#include <QSet>

namespace alidade::ui {

/// The application, which outlives what its windows throw while they handle an event.
class Application : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// After the event: the reason as `thrownReason` has it, each one once.
  void failed(const QString& reason);

 protected:
  bool event(QEvent* event) override;

 private:
  void tell(const QString& reason);

  QSet<QString> m_told;
};

}  // namespace alidade::ui

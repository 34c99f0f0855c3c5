#pragma once

#include <QFrame>
#include <QPointer>
#include <cstddef>

#include "core/session/journal.h"

class QLabel;
class QLineEdit;

namespace alidade::ui {

class SessionDocument;

/// Asks why a recorded entry was changed, below the forms and readings. It takes the keyboard only on demand,
/// so that no digit meant for the readings is lost. Return states the reason, Escape skips it. If no reason
/// is being typed, the next edit hides the bar.
class ChangeReasonBar : public QFrame {
  Q_OBJECT

 public:
  explicit ChangeReasonBar(SessionDocument& document, QWidget* parent = nullptr);

  /// Takes the keyboard; does nothing if no question is shown.
  void start();
  /// States the reason typed so far; if nothing is typed, the question stays.
  void finish();

 signals:
  void askingChanged(bool isAsking);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask(std::size_t first);
  void noteTyped();
  void end();

  SessionDocument& m_document;
  QLabel* m_question;
  QLineEdit* m_reason;
  QPointer<QWidget> m_back;  ///< the widget that had the keyboard before
  std::size_t m_first = 0, m_count = 0;
};

}  // namespace alidade::ui

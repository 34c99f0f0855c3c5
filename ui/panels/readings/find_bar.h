#pragma once

#include <QFrame>
#include <optional>

#include "core/base/problem.h"
#include "core/session/session.h"

class QLabel;
class QLineEdit;

namespace alidade::ui {

/// Asks for a text and for its next or previous match in the readings.
class FindBar : public QFrame {
  Q_OBJECT

 public:
  explicit FindBar(QWidget* parent = nullptr);

  void start();  ///< shows the bar and takes the keyboard
  void showMessage(const QString& text);

 signals:
  void wanted(const QString& text, bool forward);
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask(bool forward);

  QLineEdit* m_text;
  QLabel* m_message;
};

/// The next or previous reading entry that contains `text`, starting after the one at `from` (position, row,
/// field) and wrapping round the session. In angles only digits count: "3415" finds 341°52'24". Case is
/// ignored. Absent if there is no match.
std::optional<Place> findInReadings(const Session& session, const Place& from, const QString& text,
                                    bool forward);

}  // namespace alidade::ui

#pragma once

#include <QFrame>
#include <optional>

#include "core/base/place.h"
#include "core/session/session.h"

class QLabel;
class QLineEdit;

namespace alidade::ui {

/// Asks for a text to find in the readings, and for the next or previous place of it.
class FindBar : public QFrame {
  Q_OBJECT

 public:
  explicit FindBar(QWidget* parent = nullptr);

  void start();  ///< shows the bar, ready to type
  void tell(const QString& text);

 signals:
  void wanted(const QString& text, bool forward);
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask(bool forward);

  QLineEdit* m_text;
  QLabel* m_told;
};

/// The next entry of a reading, from the one at `from` on (its position, row and field; not itself) or back,
/// in which `text` stands, round the ends of the session. Of angles the digits count: "3415" is found in
/// 341°52'24". Capital letters are as small ones. Absent: it stands nowhere.
std::optional<Place> findInReadings(const Session& session, const Place& from, const QString& text,
                                    bool forward);

}  // namespace alidade::ui

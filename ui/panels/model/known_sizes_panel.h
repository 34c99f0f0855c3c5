#pragma once

#include <QWidget>

#include "ui/document/known_entry.h"

class QLabel;

namespace alidade::ui {

class KnownSizesTable;
class SessionDocument;

/// What is known of the effects beforehand, to be typed, and below it what is to be known of the current
/// cell.
class KnownSizesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit KnownSizesPanel(SessionDocument& document, QWidget* parent = nullptr);

  void commitOpenEditor();
  /// Is a text in it that cannot be used?
  bool hasProblem() const;
  /// Leads to an entry of the session, or to the first number of an effect.
  void reveal(const KnownPlace& place);
  void reveal(const std::string& effect);

 signals:
  void recordWanted();      ///< one to be taken
  void saveRecordWanted();  ///< of what the session says

 private:
  KnownSizesTable* m_table;
  QLabel* m_about;
};

}  // namespace alidade::ui

#pragma once

#include <QWidget>

#include "ui/document/known_entry.h"

class QLabel;

namespace alidade::ui {

class KnownSizesTable;
class SessionDocument;

/// The table of known sizes, and below it an explanation of the current cell.
class KnownSizesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit KnownSizesPanel(SessionDocument& document, QWidget* parent = nullptr);

  void commitOpenEditor();
  /// True if a text in the table is unusable.
  bool hasProblem() const;
  /// Makes a cell current: that of an entry of the session, or of the first number of an effect.
  void reveal(const KnownPlace& place);
  void reveal(const std::string& effect);

 signals:
  void recordWanted();      ///< asks to load a record
  void saveRecordWanted();  ///< asks to save a record of the session

 private:
  KnownSizesTable* m_table;
  QLabel* m_about;
};

}  // namespace alidade::ui

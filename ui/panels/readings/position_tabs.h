#pragma once

#include <QTabWidget>
#include <map>
#include <vector>

#include "core/base/problem.h"
#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

class EntryWatch;
class ReadingsTable;
class SessionDocument;
class ZeroEntries;

/// A tab for each position of the axis, with its pointing zero above its readings; then a tab for each
/// missing position, with a button to add the position.
class PositionTabs : public QTabWidget {
  Q_OBJECT

 public:
  explicit PositionTabs(SessionDocument& document, QWidget* parent = nullptr);

  ReadingsTable* table(std::size_t position) const;
  ReadingsTable* currentTable() const;  ///< null while the tab of a missing position is shown
  void setEvaluation(const SharedEvaluation& evaluation);
  void setColumnShown(ReadingColumn column, bool shown);
  /// Shows the tab of the position, or that of a missing position if the session has fewer positions.
  void showPosition(std::size_t position);
  /// Makes the entry of a field visible.
  void uncover(const Place& place);
  void selectCell(std::size_t position, std::size_t row, ReadingColumn column);

 signals:
  void rowEntered(std::size_t position, std::size_t row);
  void remark(const QString& text);
  void tableCreated(alidade::ui::ReadingsTable* table);
  void positionWanted(int axisDeg);
  /// A circle reading of the next expected row was typed; as `EntryWatch::entered`.
  void entered(std::size_t position, std::size_t row, alidade::ui::ReadingColumn column,
               const QString& doubt);
  void zeroEntered();  ///< as `ZeroEntries::entered`

 private:
  void clearPositions();
  void rebuild();
  void createMissingPage(int axisDeg);
  void showMissing();
  QWidget* createPage(std::size_t position);
  void showFurtherZeros(bool shown);
  void followZeros();
  void nameTabs();

  SessionDocument& m_document;
  EntryWatch* m_watch;
  std::vector<ReadingsTable*> m_tables;
  std::vector<ZeroEntries*> m_zeros;
  bool m_showsZeros = false;
  std::map<ReadingColumn, bool> m_shown;
};

}  // namespace alidade::ui

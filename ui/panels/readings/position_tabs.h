#pragma once

#include <QTabWidget>
#include <map>
#include <vector>

#include "core/base/place.h"
#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

class ReadingsTable;
class SessionDocument;

/// A tab for each position of the axis: its pointing zero above its readings. Behind them a tab for each
/// position that is missing, with a button that adds it.
class PositionTabs : public QTabWidget {
  Q_OBJECT

 public:
  explicit PositionTabs(SessionDocument& document, QWidget* parent = nullptr);

  ReadingsTable* table(std::size_t position) const;
  ReadingsTable* currentTable() const;  ///< null where the session has no positions
  void setEvaluation(const SharedEvaluation& evaluation);
  void setColumnShown(ReadingColumn column, bool shown);
  /// The tab of the position, or that of a missing one where there are not so many.
  void showPosition(std::size_t position);
  void selectCell(std::size_t position, std::size_t row, ReadingColumn column);

 signals:
  void rowEntered(std::size_t position, std::size_t row);
  void remark(const QString& text);
  void tableCreated(alidade::ui::ReadingsTable* table);
  void positionWanted(int axisDeg);

 private:
  void clearPositions();
  void rebuild();
  void createMissingPage(int axisDeg);
  void showMissing();
  QWidget* createPage(std::size_t position);
  QWidget* createZeroEntries(std::size_t position);
  void nameTabs();

  SessionDocument& m_document;
  std::vector<ReadingsTable*> m_tables;
  std::map<ReadingColumn, bool> m_shown;
};

}  // namespace alidade::ui

#pragma once

#include <QTabWidget>
#include <map>
#include <vector>

#include "core/base/place.h"
#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

class EntryWatch;
class ReadingsTable;
class SessionDocument;
class ZeroEntries;

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
  /// Makes sure that the entry of a field is not hidden.
  void uncover(const Place& place);
  void selectCell(std::size_t position, std::size_t row, ReadingColumn column);

 signals:
  void rowEntered(std::size_t position, std::size_t row);
  void remark(const QString& text);
  void tableCreated(alidade::ui::ReadingsTable* table);
  void positionWanted(int axisDeg);
  /// A circle was read that was to be read next; `doubt` is empty where it is as expected (`EntryWatch`).
  void entered(const QString& doubt);

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

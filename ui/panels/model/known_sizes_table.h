#pragma once

#include <QStringList>
#include <vector>

#include "ui/models/known_sizes_model.h"
#include "ui/panels/parts/entry_table.h"

namespace alidade::ui {

/// The table of known sizes of the catalogue's numbers. Enter and Tab move from value to u to source, then to
/// the next number.
class KnownSizesTable : public EntryTable {
  Q_OBJECT

 public:
  explicit KnownSizesTable(SessionDocument& document, QWidget* parent = nullptr);

  const KnownSizesModel& sizes() const { return m_model; }
  void reveal(const QModelIndex& cell) {
    if (cell.isValid()) goTo(cell);
  }

  void copy() const override;
  void cut() override;
  void paste() override;
  void clearCells() override;

 signals:
  void explanationChanged(const QString& about);  ///< an explanation of the current cell

 protected:
  QModelIndex onward(const QModelIndex& from, int key) const override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight,
                   const QList<int>& roles) override;

 private:
  struct NewText {
    int row, column;
    QString text;
  };

  void type(std::vector<NewText> texts, const QString& undoText);
  bool changes(const NewText& text) const;
  void keepCurrentOverResets();
  void layOutColumns();

  SessionDocument& m_document;
  KnownSizesModel m_model;
};

}  // namespace alidade::ui

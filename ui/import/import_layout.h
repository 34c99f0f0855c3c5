#pragma once

#include <QWidget>
#include <vector>

#include "ui/import/import_source.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace alidade::ui {

/// How a table is taken: unit, decimal sign, rows before the readings, and what each column holds. An angle
/// may stand in several columns, as its degrees, minutes and seconds: where the numbers or names allow it,
/// they are one choice.
class ImportLayout : public QWidget {
  Q_OBJECT

 public:
  ImportLayout();

  /// The layout of a table, to be edited; of other files it says why they are taken as they are.
  void show(const ImportSource& source, const TableLayout& layout, bool isRemembered);
  const TableLayout& layout() const { return m_layout; }

 signals:
  void chosen();

 private:
  struct Role {
    std::string key;
    QLabel* label;
    QComboBox* column;  ///< its data: the columns, from 0, with commas between them
  };

  QWidget* createForm();
  void addRole(QGridLayout& grid, const std::string& key, const QString& label);
  void fillColumns(const ImportSource& source);
  void fillRole(const Role& role, const ImportSource& source) const;
  void addChoice(const Role& role, const ImportSource& source, const std::vector<std::size_t>& columns) const;
  void take();

  QLabel* m_reasons;
  QWidget* m_table;
  QComboBox *m_unit, *m_decimalSign;
  QSpinBox* m_headRows;
  std::vector<Role> m_roles;
  TableLayout m_layout;
  bool m_isFilling = false;
};

}  // namespace alidade::ui

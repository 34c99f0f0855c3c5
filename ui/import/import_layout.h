#pragma once

#include <QWidget>
#include <vector>

#include "ui/import/import_source.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace alidade::ui {

/// The layout of a table: unit, decimal sign, rows before the readings, and the role of each column. Columns
/// whose numbers or names can be degrees, minutes and seconds are also offered as one choice.
class ImportLayout : public QWidget {
  Q_OBJECT

 public:
  ImportLayout();

  /// Shows the reasons for the proposed format and, for a table, the layout to be edited.
  void show(const ImportSource& source, const TableLayout& layout, bool isRemembered);
  const TableLayout& layout() const { return m_layout; }

 signals:
  void chosen();

 private:
  struct Role {
    std::string key;
    QLabel* label;
    QComboBox* column;  ///< item data: column numbers from 0, separated by commas
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

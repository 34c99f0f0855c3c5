#pragma once

#include <QWidget>

#include "ui/jobs/instrument_job.h"

namespace alidade::ui {

class DataTable;

/// The results of an instrument check for each station, pooled in the last row.
class CheckTable : public QWidget {
  Q_OBJECT

 public:
  explicit CheckTable(QWidget* parent = nullptr);

  void setCheck(const SharedInstrument& check);

 private:
  /// Null: the row of all stations.
  const StationCheck* stationAt(int row) const;
  DataTable* createTable();

  SharedInstrument m_check;
  DataTable* m_table;
};

}  // namespace alidade::ui

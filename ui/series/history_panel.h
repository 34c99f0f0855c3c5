#pragma once

#include <QWidget>

#include "ui/series/series_job.h"

class QComboBox;
class QLabel;

namespace alidade::ui {

class HistoryChart;

/// One quantity of one device over time: its control chart, what it says, and two sessions compared.
class HistoryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(QWidget* parent = nullptr);

  /// Null: there are no sessions.
  void setSeries(const SharedSeries& series);
  /// Of the device shown; null: none.
  const DeviceHistory* device() const;
  /// Compares the two sessions of these files, where both are of the device shown; else says how to.
  void compare(const std::vector<std::string>& files);
  /// The point of this file's session.
  void highlight(const std::string& file);

 signals:
  void deviceChosen();
  /// A point was activated.
  void sessionWanted(const std::string& file);
  void sessionStepped(const std::string& file);

 private:
  QWidget* createChoices();
  QWidget* createText();
  void showDevices();
  void showQuantities();
  void showHistory();
  void activate(std::size_t value, bool wanted);
  const QuantityHistory* quantity() const;

  SharedSeries m_series;
  std::vector<std::string> m_compared;
  QComboBox *m_devices, *m_quantities;
  HistoryChart* m_chart;
  QLabel *m_says, *m_congruence, *m_devicesLabel;
};

}  // namespace alidade::ui

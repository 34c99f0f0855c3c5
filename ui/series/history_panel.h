#pragma once

#include <QWidget>

#include "ui/jobs/series_job.h"

class QLabel;

namespace alidade::ui {

class HistoryChart;
class HistoryChoices;

/// One quantity of one device over time: its control chart, the conclusions, and a comparison of two
/// sessions.
class HistoryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(QWidget* parent = nullptr);

  /// Null: no sessions.
  void setSeries(const SharedSeries& series);
  /// The number of first sessions in the baseline of every device; 0: all.
  void setBaseline(int sessions);
  int baseline() const;
  /// The history of the device shown, with the baseline; null if there is none.
  const DeviceHistory* device() const;
  const std::vector<DeviceHistory>& devices() const { return m_deviceHistories; }
  /// Compares the sessions of these two files, if both belong to the device shown; else shows how to compare.
  void compare(const std::vector<std::string>& files);
  /// Highlights the point of this file's session.
  void highlight(const std::string& file);

 signals:
  void baselineChosen();
  void deviceChosen();
  /// A point was activated.
  void sessionWanted(const std::string& file);
  void sessionStepped(const std::string& file);

 private:
  QWidget* createText();
  void showQuantities();
  void showHistory();
  void activate(std::size_t value, bool wanted);
  const QuantityHistory* quantity() const;

  void takeBaseline();

  std::vector<DeviceHistory> m_deviceHistories;
  std::vector<std::string> m_compared;
  HistoryChoices* m_choices;
  HistoryChart* m_chart;
  QLabel *m_says, *m_congruence;
};

}  // namespace alidade::ui

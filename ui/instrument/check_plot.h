#pragma once

#include <QtCharts/QLineSeries>
#include <vector>

#include "ui/charts/plotting/plot.h"
#include "ui/jobs/instrument_job.h"

namespace alidade::ui {

/// The results of an instrument check as points: collimation, index and orientation over the rounds of all
/// stations in sequence, the residuals of every pair, or the collimation of each target over its distance.
/// Kinds of points differ in shape and fill, and so also in grey print.
class CheckPlot : public Plot {
  Q_OBJECT

 public:
  enum class View { Course, Residuals, Distance };

  explicit CheckPlot(QObject* parent = nullptr);

  /// An instrument check is independent of sessions.
  void setEvaluation(const Evaluation&) override {}
  void setCheck(const SharedInstrument& check);
  void setView(View view);
  View view() const { return m_view; }

  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  void placeExtras() override;
  double leastXStep() const override { return m_view == View::Distance ? 0 : 1; }  // rounds

 private:
  enum class Kind { Collimation, Index, Orientation, Direction, Zenith };
  /// One point, with the station, round and target that it shows.
  struct Point {
    double x, y;
    Kind kind;
    const StationCheck* station;
    std::size_t round, target;  ///< no target in `View::Course`, no round in `View::Distance`
  };

  void draw();
  void addCourse(const StationCheck& station, std::size_t before);
  void addResiduals(const StationCheck& station, std::size_t before);
  void addDistances(const StationCheck& station);
  void add(Point point);
  void showTitles();
  void showLegend();
  QString nameOf(Kind kind) const;
  Marker markerOf(Kind kind) const;

  SharedInstrument m_check;
  View m_view = View::Course;
  std::vector<Point> m_points;
  QRectF m_extent{0, -1, 1, 2};
  QLineSeries* m_zero;  // owned by the chart
};

}  // namespace alidade::ui

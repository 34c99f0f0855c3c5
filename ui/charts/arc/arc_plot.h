#pragma once

#include <QtCharts/QLineSeries>
#include <array>
#include <memory>

#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/arc/centres_inset.h"
#include "ui/charts/arc/side_view.h"
#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

/// Both fitted arcs in o0 with the sighted points, in true proportion at every size. Residuals are enlarged
/// by a stated factor. An inset shows the centres, which are a few mm apart in a picture of 800 mm. Rounds
/// and faces of one place are shown side by side along the arc.
class ArcPlot : public Plot {
  Q_OBJECT

 public:
  explicit ArcPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation) override;
  /// The headline of the same evaluation, for the inset and the view along the axis.
  void setHeadline(const Headline& headline);
  QString describe(const Mark& mark) const override;
  /// In the inset: the whole warning of the headline, if the inset shows only a part of it.
  QString tipAt(const QPointF& scene) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;
  void setChoice(const RowChoice& choice);
  const RowChoice& choice() const { return m_choice; }

  const ArcPicture& picture() const { return *m_picture; }
  const CentresInset& inset() const { return *m_inset; }
  const SideView& sideView() const { return *m_side; }

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  bool hasEqualScales() const override { return true; }
  void adaptTo(const QSizeF& size) override;
  void placeExtras() override;

 private:
  static constexpr std::size_t mostPieces = 4;  ///< largest number of pieces into which a frame cuts a circle

  void showArcs();
  void drawMarks();
  void showLegend();
  void placeViews();
  void placeInset();
  void placeSideView();
  bool placeSideViewBelowInset();
  double cornerOfSideView() const;
  bool isDrawn(const DrawnSighting& sighting) const { return m_drawn.takes(sighting.round, sighting.face); }
  QPointF shiftOf(const DrawnSighting& sighting) const;
  const DrawnSighting* sightingOf(const Mark& mark) const;

  std::shared_ptr<const ArcPicture> m_picture = std::make_shared<const ArcPicture>();
  QRectF m_extent;  // extent of the picture
  RowChoice m_choice;
  RowChoice m_drawn;  // the part of the choice available in the picture
  RowSlots m_slots;
  double m_unit = 0;  // unit of the style, which sets the shift of marks
  std::array<std::array<QLineSeries*, mostPieces>, 2> m_arcs;  // axis at 0°, at 180°; owned by the chart
  CentresInset* m_inset;                                       // owned by the chart
  SideView* m_side;                                            // owned by the chart
};

}  // namespace alidade::ui

#pragma once

#include <QtCharts/QLineSeries>
#include <array>
#include <memory>

#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/arc/centres_inset.h"
#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

/// Both fitted arcs in o0 with the sighted points, in true proportion at every size; residuals enlarged by a
/// stated factor; the centres in an inset of their own, since they lie a few mm apart in a picture of 800 mm.
/// Rounds and faces of one place stand side by side along the arc.
class ArcPlot : public Plot {
  Q_OBJECT

 public:
  explicit ArcPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation) override;
  /// Of the same evaluation, in the inset.
  void setHeadline(const Headline& headline) { m_inset->setHeadline(headline); }
  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;
  void setChoice(const RowChoice& choice);
  const RowChoice& choice() const { return m_choice; }

  const ArcPicture& picture() const { return *m_picture; }
  const CentresInset& inset() const { return *m_inset; }

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  bool hasEqualScales() const override { return true; }
  void adaptTo(const QSizeF& size) override;
  void placeExtras() override;

 private:
  static constexpr std::size_t mostPieces = 4;  ///< that a frame can cut a circle into

  void showArcs();
  void drawMarks();
  void showLegend();
  void placeInset();
  bool isDrawn(const DrawnSighting& sighting) const { return m_drawn.takes(sighting.round, sighting.face); }
  QPointF shiftOf(const DrawnSighting& sighting) const;
  const DrawnSighting* sightingOf(const Mark& mark) const;

  std::shared_ptr<const ArcPicture> m_picture = std::make_shared<const ArcPicture>();
  QRectF m_extent;  // of the picture
  RowChoice m_choice;
  RowChoice m_drawn;  // what of it the picture has
  RowSlots m_slots;
  double m_unit = 0;                                           // of the style that the marks stand apart in
  std::array<std::array<QLineSeries*, mostPieces>, 2> m_arcs;  // axis at 0°, at 180°; owned by the chart
  CentresInset* m_inset;                                       // owned by the chart
};

}  // namespace alidade::ui

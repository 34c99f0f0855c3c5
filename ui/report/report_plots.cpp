#include "ui/report/report_parts.h"

#include <QPainter>
#include <algorithm>

#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/report/report_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

/// Sentences of the caption on the rings, faces and rounds that occur.
template <typename Drawn>
QStringList markSentences(const std::vector<Drawn>& drawn, const RowKinds& kinds) {
  const bool isRinged =
      std::any_of(drawn.begin(), drawn.end(), [](const Drawn& one) { return one.repeat > 1; });
  QStringList sentences;
  if (isRinged) sentences.append(Report::tr("Ringed: a position measured again."));
  if (kinds.hasTwoFaces()) sentences.append(Report::tr("Struck through: face 2."));
  if (kinds.rounds.size() > 1) sentences.append(Report::tr("Rounds are drawn side by side."));
  return sentences;
}

QStringList insetSentences(const DrawnIntersection& intersection) {
  QStringList sentences{
      Report::tr("Inset: the arc centres O1 and O2 of the fit, with the axis midway between them. The heavy "
                 "line is Δd, fit only; the bar at its end is the expanded uncertainty U. Each ellipse "
                 "contains its centre with a probability of %1 %.")
          .arg(plainNumberText(100 * intersection.coverage))};
  if (intersection.tolerance)
    sentences.append(Report::tr("Grey: permitted places of the centres, tolerance ± %1 mm.")
                         .arg(plainNumberText(*intersection.tolerance)));
  sentences.append(
      Report::tr("Δx leads from O2 to the cross, where O2 would be if the positions agreed; without a cross, "
                 "they agree."));
  return sentences;
}

QString arcCaption(const ArcPlot& plot) {
  const ArcPicture& picture = plot.picture();
  if (picture.arcs.empty())
    return Report::tr("Figure 1. Sighted points in the arc plane; no arc was fitted.");
  QStringList sentences{
      Report::tr("Figure 1. Fitted arcs and sighted points in true proportion, frame at the theodolite, x "
                 "right, y up. Filled points and full line: axis at 0°; hollow points and broken line: "
                 "180°.")};
  sentences += markSentences(picture.sightings, picture.kinds);
  sentences.append(
      //: %1: how many times as long, "× 500"
      Report::tr("The strokes are the residuals, from the adjusted point on the arc, enlarged %1.")
          .arg(exaggerationText(picture.exaggeration)));
  if (picture.intersection) sentences += insetSentences(*picture.intersection);
  if (plot.sideView().scale() > 0)
    sentences.append(
        Report::tr("View along the axis: the arc centre at 0° with its U, Δd upwards and Δz towards the "
                   "theodolite; at 180° the centre is on the opposite side."));
  return Report::sentences(sentences);
}

QString residualCaption(const ResidualPicture& picture, int figure) {
  if (picture.isEmpty()) return Report::tr("Figure %1. No residuals, since no arc was fitted.").arg(figure);
  const auto sigma = [](double arcsec) { return plainNumberText(arcsec) + QChar(0x2033); };
  QStringList sentences{
      Report::tr("Figure %1. Residuals of the readings, observed minus adjusted, right and up positive, "
                 "along the slider coordinate. Circles: horizontal, diamonds: vertical; filled: axis at 0°, "
                 "hollow: 180°.")
          .arg(figure)};
  sentences += markSentences(picture.residuals, picture.kinds);
  sentences.append(Report::tr("Grey band: ±1σ, broken lines: ±3σ of the stated noise (σ = %1 horizontal, %2 "
                              "vertical).")
                       .arg(sigma(picture.sigmaHorizontal), sigma(picture.sigmaVertical)));
  return Report::sentences(sentences);
}

}  // namespace

void addPlot(ReportSheet& sheet, const std::shared_ptr<Plot>& plot, double height) {
  constexpr double sceneUnitsPerMillimetre = 96 / 25.4;
  const QRectF area(0, sheet.y(), ReportSheet::width, height);
  plot->setStyle(printStyle(reportFontFamily()));
  plot->arrange(area.size() * sceneUnitsPerMillimetre);
  sheet.draw([plot, target = sheet.inDeviceUnits(area)](QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    plot->scene()->render(&painter, target, plot->scene()->sceneRect());
  });
  sheet.skip(height + 1.5);
}

namespace {

/// The height that a caption leaves for its plot on this page; starts a new page if too little is left.
double roomAbove(ReportSheet& sheet, const QString& caption) {
  constexpr double least = 50, between = 2;  // mm
  const auto lines = static_cast<double>(sheet.lines(caption, type::small, ReportSheet::width).size());
  const double below = lines * sheet.lineHeight(type::small) + between;
  sheet.keepTogether(least + below);
  return sheet.room() - below;
}

}  // namespace

void addPlots(ReportSheet& sheet, const Gap& gap, bool hasArcs, bool hasResiduals) {
  if (!hasArcs && !hasResiduals) return;
  const double lacking = 252 - sheet.height();  // mm by which the text area is lower than on A4
  const double arcsHeight = 126 - 0.6 * lacking, residualsHeight = 86 - 0.4 * lacking;
  constexpr double aroundPlot = 25;  // heading and caption
  if (hasArcs && hasResiduals)
    sheet.newPage();
  else
    sheet.keepTogether((hasArcs ? arcsHeight : residualsHeight) + aroundPlot);
  sheet.heading(!hasResiduals ? Report::tr("Arcs")
                : hasArcs     ? Report::tr("Arcs and residuals")
                              : Report::tr("Residuals"));
  if (hasArcs) {
    const auto arcs = std::make_shared<ArcPlot>();
    arcs->setHeadline(headlineOf(gap));
    arcs->setEvaluation(*gap.evaluation);
    addPlot(sheet, arcs, arcsHeight);
    sheet.paragraph(arcCaption(*arcs), type::small);
  }
  if (!hasResiduals) return;
  if (hasArcs) {
    sheet.skip(3);
    sheet.mayBreak();
  }
  const auto residuals = std::make_shared<ResidualPlot>();
  residuals->setEvaluation(*gap.evaluation);
  const QString caption = residualCaption(residuals->picture(), hasArcs ? 2 : 1);
  addPlot(sheet, residuals, std::min(residualsHeight, roomAbove(sheet, caption)));
  sheet.paragraph(caption, type::small);
}

}  // namespace alidade::ui

#include "ui/charts/residuals/residual_choice.h"

#include <gtest/gtest.h>

#include <QMenu>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "core/exchange/csv_table.h"
#include "tests/ui/support.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

using Over = ResidualChoice::Over;

const Evaluation& fullEvaluation() {
  static const Evaluation evaluation = evaluateFit(sessionInTwoFaces());
  return evaluation;
}

std::size_t countOf(const ResidualPicture& picture, CircleRead circle) {
  return static_cast<std::size_t>(std::ranges::count(picture.residuals, circle, &DrawnResidual::circle));
}

TEST(ResidualChoice, HoldsSliderReadingsBehindTheCircles) {
  const ResidualPicture picture = residualPicture(fullEvaluation());
  const std::size_t sliders = countOf(picture, CircleRead::Slider);
  ASSERT_GT(sliders, 0u);
  EXPECT_EQ(countOf(picture, CircleRead::Horizontal), countOf(picture, CircleRead::Vertical));
  EXPECT_EQ(picture.residuals.back().circle, CircleRead::Slider);
  EXPECT_EQ(picture.residuals.size(), fullEvaluation().fit.joint.readings.size());
  // The χ² of the readings alone, since that of the fit may include observed zeros.
  double squares = 0, ofFit = 0;
  for (const DrawnResidual& one : picture.residuals)
    if (one.circle == CircleRead::Slider) squares += one.arcsec * one.arcsec;
  for (const AdjustedReading& reading : fullEvaluation().fit.joint.readings)
    if (reading.kind == ReadingKind::Slider)
      ofFit += std::pow(Angle::fromRadians(reading.residual).arcseconds(), 2);
  EXPECT_NEAR(squares, ofFit, 1e-6 * ofFit);
}

TEST(ResidualChoice, DrawsOverWhatIsChosen) {
  ResidualPlot plot;
  plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  plot.setEvaluation(fullEvaluation());
  const Measurement& measurement = *fullEvaluation().examined.measurement;
  const auto sightingOf = [&](const Mark& mark) -> const Sighting& {
    const auto arc = std::ranges::find(measurement.arcs, mark.ref.position, &ArcMeasurement::position);
    return *std::ranges::find(arc->sightings, mark.ref.row, &Sighting::row);
  };
  const std::map<Over, std::function<double(const Sighting&)>> truths{
      {Over::Order, [](const Sighting& one) { return static_cast<double>(one.sequence) + 1; }},
      {Over::Elevation, [](const Sighting& one) { return one.e.degrees(); }},
      {Over::Azimuth, [](const Sighting& one) { return one.a.degrees(); }}};
  std::set<QString> standards{plot.standard()};
  for (const auto& [over, truth] : truths) {
    plot.setChoice({.over = over});
    for (const Mark& mark : plot.markers().marks()) EXPECT_NEAR(mark.at.x(), truth(sightingOf(mark)), 1e-9);
    plot.arrange({700, 400});
    for (const Mark& mark : plot.markers().marks())
      EXPECT_TRUE(plot.plotArea().contains(plot.markers().scenePosition(mark)));
    standards.insert(plot.standard());
  }
  EXPECT_GE(standards.size(), 2u);
}

TEST(ResidualChoice, DrawsTheCirclesThatAreChosen) {
  ResidualPlot plot;
  plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  plot.setEvaluation(fullEvaluation());
  const std::size_t ofACircle = countOf(plot.picture(), CircleRead::Vertical);
  EXPECT_EQ(plot.markers().marks().size(), 2 * ofACircle);
  plot.setChoice({.horizontal = false});
  EXPECT_EQ(plot.markers().marks().size(), ofACircle);
  plot.setChoice({.horizontal = false, .vertical = false, .slider = true});
  EXPECT_EQ(plot.markers().marks().size(), countOf(plot.picture(), CircleRead::Slider));
  EXPECT_TRUE(plot.describe(plot.markers().marks()[0]).contains(QStringLiteral("slider: ")));
  QStringList texts;
  for (const LegendEntry& entry : plot.legend().entries()) texts.append(entry.text);
  EXPECT_TRUE(texts.contains(QStringLiteral("±1σ, stated σ = 5″"))) << texts.join(u'\n').toStdString();
  plot.setChoice({.slider = true});
  texts.clear();
  for (const LegendEntry& entry : plot.legend().entries()) texts.append(entry.text);
  EXPECT_TRUE(texts.contains(QStringLiteral("±1σ horizontal, vertical, stated σ = 2″")))
      << texts.join(u'\n').toStdString();
  EXPECT_TRUE(texts.contains(QStringLiteral("±1σ slider, stated σ = 5″")));
  plot.setEvaluation(evaluate(paperSession()));
  plot.setChoice({.horizontal = false, .vertical = false, .slider = true});
  EXPECT_FALSE(plot.message().isEmpty()) << "the paper has none";
}

TEST(ResidualChoice, DrawsStandardisedResiduals) {
  const Evaluation evaluation = evaluate(paperSession());
  ResidualPlot plot;
  plot.setEvaluation(evaluation);
  plot.setChoice({.isStandardised = true});
  ASSERT_EQ(plot.markers().marks().size(), 68u);
  double squares = 0;
  for (const Mark& mark : plot.markers().marks()) squares += mark.at.y() * mark.at.y();
  EXPECT_NEAR(squares / 68, 1, 0.1) << "their scatter is their unit";
  EXPECT_DOUBLE_EQ(plot.markers().marks()[0].at.y(),
                   evaluation.fit.arcs[0].residuals[0].horizontalStandardised);
}

// Compares with the plotting positions of scipy.stats.probplot: only ranks matter.
TEST(ResidualChoice, DrawsThemOverTheirNormalQuantiles) {
  ResidualPlot plot;
  plot.setEvaluation(evaluate(paperSession()));
  plot.setChoice({.over = Over::Normal});
  auto marks = plot.markers().marks();
  ASSERT_EQ(marks.size(), 68u);
  std::ranges::sort(marks, {}, [](const Mark& mark) { return mark.at.x(); });
  EXPECT_TRUE(std::ranges::is_sorted(marks, {}, [](const Mark& mark) { return mark.at.y(); }));
  EXPECT_NEAR(marks.front().at.x(), -2.35919, 1e-5) << "z of 0.625/68.25";
  for (std::size_t i = 0; i < marks.size(); ++i)
    EXPECT_NEAR(marks[i].at.x(), -marks[marks.size() - 1 - i].at.x(), 1e-9);
  const NormalEnvelope envelope = normalEnvelope(68);
  ASSERT_EQ(envelope.lower.size(), envelope.upper.size());
  for (qsizetype i = 0; i < envelope.lower.size(); ++i) {
    EXPECT_EQ(envelope.lower[i].x(), envelope.upper[i].x());
    EXPECT_LT(envelope.lower[i].y(), envelope.upper[i].y());
    EXPECT_LT(envelope.lower[i].y(), envelope.lower[i].x() + 1e-9);
    EXPECT_GT(envelope.upper[i].y(), envelope.upper[i].x() - 1e-9);
  }
  EXPECT_TRUE(normalEnvelope(1).lower.isEmpty());
}

// Blom's scores of ten values, Φ⁻¹((i − 3/8)/(n + 1/4)), as tables print them.
TEST(ResidualChoice, DrawsTenValuesOverBlomsScores) {
  const double values[] = {0.4, -1.9, 2.2, -0.3, 0.1, 1.1, -0.8, 0.7, -1.2, 0.2};
  const std::map<double, double> scores{{-1.9, -1.5466}, {-1.2, -1.0005}, {-0.8, -0.6554}, {-0.3, -0.3755},
                                        {0.1, -0.1226},  {0.2, 0.1226},   {0.4, 0.3755},   {0.7, 0.6554},
                                        {1.1, 1.0005},   {2.2, 1.5466}};
  ResidualPicture picture;
  for (std::uint32_t i = 0; i < 10; ++i) {
    picture.residuals.push_back({.ref = {0, i}, .standardised = values[i]});
    picture.byStandardised.push_back(i);
  }
  std::ranges::sort(picture.byStandardised, {}, [&](std::uint32_t i) { return values[i]; });
  const auto points = residualPoints(picture, {.over = Over::Normal});
  ASSERT_EQ(points.size(), 10u);
  for (const ResidualPoint& point : points) {
    EXPECT_EQ(point.at.y(), values[point.index]);
    EXPECT_NEAR(point.at.x(), scores.at(point.at.y()), 5e-5);
  }
}

/// The height of a curve at `x`.
double on(const QList<QPointF>& curve, double x) {
  qsizetype i = 1;
  while (i + 1 < curve.size() && curve[i].x() < x) ++i;
  const QPointF &a = curve[i - 1], &b = curve[i];
  return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
}

// The envelope contains 19 of 20 ranks of normal values.
TEST(ResidualChoice, TheEnvelopeHoldsNormalValues) {
  int inside = 0, all = 0;
  const NormalEnvelope envelope = normalEnvelope(40);
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    ResidualPicture picture;
    for (std::uint32_t i = 0; i < 40; ++i)
      picture.residuals.push_back({.ref = {0, i}, .standardised = normal(random)});
    for (std::uint32_t i = 0; i < 40; ++i) picture.byStandardised.push_back(i);
    std::ranges::sort(picture.byStandardised, {},
                      [&](std::uint32_t i) { return picture.residuals[i].standardised; });
    for (const ResidualPoint& point : residualPoints(picture, {.over = Over::Normal})) {
      ++all;
      inside +=
          point.at.y() > on(envelope.lower, point.at.x()) && point.at.y() < on(envelope.upper, point.at.x())
              ? 1
              : 0;
    }
  }
  EXPECT_NEAR(inside / static_cast<double>(all), 0.95, 0.015);
}

TEST(ResidualChoice, ItsTableHoldsWhatTheFitLeftOver) {
  const Evaluation evaluation = evaluate(paperSession());
  ResidualPlot plot;
  plot.setEvaluation(evaluation);
  plot.setChoice({.over = Over::Order, .vertical = false});
  const std::string csv = plot.csv();
  CsvTable table(csv);
  EXPECT_EQ(table.next()->cells[10].text, "residual_arcsec");
  for (const ArcFit& arc : evaluation.fit.arcs)
    for (const SightingResidual& residual : arc.residuals) {
      const auto row = table.next();
      ASSERT_TRUE(row);
      EXPECT_EQ(row->cells[0].text, std::to_string(arc.axisDeg));
      EXPECT_EQ(row->cells[5].text, "horizontal");
      EXPECT_DOUBLE_EQ(std::stod(row->cells[10].text), residual.horizontal.arcseconds());
      EXPECT_DOUBLE_EQ(std::stod(row->cells[11].text), residual.horizontalStandardised);
    }
  EXPECT_FALSE(table.next());
}

TEST(ResidualChoice, IsKeptForTheNextWindow) {
  QSettings().remove(QStringLiteral("charts"));
  EXPECT_EQ(keptResidualChoice(), ResidualChoice());
  const ResidualChoice choice{.over = Over::Azimuth,
                              .isStandardised = true,
                              .rows = {.round = 2, .face = 1},
                              .vertical = false,
                              .slider = true,
                              .reaches = {0, 4, 0, 12.5, 0}};
  {
    ResidualChart chart;
    chart.choose(choice);
    EXPECT_EQ(chart.plot()->choice(), choice);
  }
  EXPECT_EQ(keptResidualChoice(), choice);
  EXPECT_EQ(ResidualChart().plot()->choice(), choice);
  QSettings().setValue(QStringLiteral("charts/residuals/over"), 77);
  QSettings().setValue(QStringLiteral("charts/residuals/reaches"), QVariantList{-3, QStringLiteral("wide")});
  EXPECT_EQ(keptResidualChoice().over, Over::Slider) << "what means nothing is as usual";
  EXPECT_EQ(keptResidualChoice().reaches, ResidualChoice().reaches);
  QSettings().remove(QStringLiteral("charts"));
}

QAction* entryOf(const QMenu& menu, const QString& text) {
  for (QAction* action : menu.actions()) {
    if (action->menu())
      if (QAction* found = entryOf(*action->menu(), text)) return found;
    if (action->text().remove(u'&') == text) return action;
  }
  return nullptr;
}

TEST(ResidualChoice, IsMadeInTheMenu) {
  ResidualChart chart;
  chart.setEvaluation(fullEvaluation());
  const auto trigger = [&](const QString& text) {
    const auto menu = chart.makeMenu();
    QAction* action = entryOf(*menu, text);
    ASSERT_TRUE(action) << text.toStdString();
    ASSERT_TRUE(action->isEnabled()) << text.toStdString();
    action->trigger();
  };
  trigger(QStringLiteral("Standardised"));
  EXPECT_TRUE(chart.plot()->choice().isStandardised);
  trigger(QStringLiteral("Round 2"));
  trigger(QStringLiteral("Face 2"));
  EXPECT_EQ(chart.plot()->choice().rows, (RowChoice{.round = 2, .face = 2}));
  trigger(QStringLiteral("Horizontal"));
  EXPECT_FALSE(chart.plot()->choice().horizontal);
  EXPECT_FALSE(entryOf(*chart.makeMenu(), QStringLiteral("Vertical"))->isEnabled()) << "the last one stays";
  trigger(QStringLiteral("All Rounds"));
  EXPECT_EQ(chart.plot()->choice().rows.round, std::nullopt);
  for (const Mark& mark : chart.plot()->markers().marks())
    EXPECT_EQ(chart.plot()->picture().residuals[mark.index].face, 2);
  QSettings().remove(QStringLiteral("charts"));
}

}  // namespace
}  // namespace alidade::ui

#include "ui/report/report_parts.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/evaluation/findings.h"
#include "core/statement/budget.h"
#include "core/statement/headline.h"
#include "ui/charts/plotting/tolerance_picture.h"
#include "ui/report/report_statement.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/accessible_place.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

const QColor red(0xb0, 0x00, 0x20);
const QColor pale(0xf2, 0xf2, 0xf2);
const TextStyle large{.points = 15, .bold = true};

QString percent(double share) {
  return plainNumberText(std::round(share * 1e6) / 1e4) + QStringLiteral(" %");
}

QString coverageLine(const Gap& gap, const Headline& headline) {
  const Intersection& fitted = *gap.evaluation->fit.intersection;
  const auto u = [](double sigma) { return lengthText(sigma, decimalsFor(sigma)); };
  QStringList sentences{Report::tr("U: coverage %1.").arg(percent(fitted.coverage))};
  if (const MeasuredIntersection* measured = gap.measured())
    sentences.append(Report::tr("Δd, measured: u = %1, ν = %2.")
                         .arg(u(measured->estimate.sigma),
                              qText(degreesOfFreedomText(measured->estimate.degreesOfFreedom))));
  //: %1: "Δd, fit only: 1.31 ± 0.21 mm"
  sentences.append(Report::tr("%1, k = %2, u = %3, ν = %4.")
                       .arg(qText(headline.fitOnly), numberText(fitted.coverageFactor, 2), u(fitted.sigma),
                            qText(degreesOfFreedomText(fitted.effectiveDegreesOfFreedom))));
  return Report::sentences(sentences);
}

QString problemText(const Session& session, const Problem& problem) {
  const QString place = accessiblePlace(session, problem.where);
  if (place.isEmpty()) return qText(problem.what);
  //: a place, and what is wrong there
  return Report::tr("%1: %2").arg(place, qText(problem.what));
}

/// Refers to the findings, so that a verdict is never read without them.
QString findingsLine(const Gap& gap) {
  const std::vector<Finding> findings = findingsOf(*gap.evaluation);
  const auto serious =
      std::count_if(findings.begin(), findings.end(),
                    [](const Finding& finding) { return finding.severity != Severity::Note; }) +
      (gap.evaluation->suspects.empty() ? 0 : 1) + (gap.isOpen() ? 1 : 0);
  if (serious == 0) return {};
  return serious == 1 ? Report::tr("1 finding: see below.")
                      : Report::tr("%1 findings: see below.").arg(serious);
}

void addArcs(ReportSheet& sheet, const SessionFit& fit) {
  constexpr auto right = Qt::AlignRight;
  ReportTable table(sheet, {{Report::tr("Arc"), 28},
                            {QStringLiteral("x (mm)"), 18, right},
                            {QStringLiteral("u(x)"), 13, right},
                            {QStringLiteral("y (mm)"), 18, right},
                            {QStringLiteral("u(y)"), 13, right},
                            {QStringLiteral("R (mm)"), 20, right},
                            {QStringLiteral("u(R)"), 13, right},
                            {QStringLiteral("n"), 11, right},
                            {Report::tr("rms"), 14, right},
                            {QStringLiteral("χ²/f"), 12, right},
                            {QStringLiteral("f"), 10, right}});
  table.head();
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcFit& arc = fit.arcs[i];
    const ArcSigma& sigma = fit.sigmas[i];
    const int decimals = std::max({decimalsFor(sigma.x), decimalsFor(sigma.y), decimalsFor(sigma.radius)});
    const auto length = [decimals](double value) { return numberText(value, decimals); };
    //: an arc and the position of its axis: "O1 at 0°"
    table.row({Report::tr("%1 at %2")
                   .arg(arc.axisDeg == 0 ? QStringLiteral("O1") : QStringLiteral("O2"),
                        positionText(arc.axisDeg, arc.time)),
               length(arc.circle.x), length(sigma.x), length(arc.circle.y), length(sigma.y),
               length(arc.circle.radius), length(sigma.radius), QString::number(arc.residuals.size()),
               arcsecText(arc.residualRms, 2),
               arc.degreesOfFreedom > 0 ? numberText(arc.reducedChiSquare(), 2) : notStated(),
               QString::number(arc.degreesOfFreedom)});
  }
  table.finish();
}

void addEffects(ReportSheet& sheet, const std::vector<EffectEstimate>& effects) {
  if (effects.empty()) return;
  constexpr auto right = Qt::AlignRight;
  sheet.keepTogether((static_cast<double>(effects.size()) + 3) * 4.5);
  sheet.heading(Report::tr("Model effects"));
  ReportTable table(sheet, {{Report::tr("Estimated along with the arcs"), 80},
                            {Report::tr("value"), 30, right},
                            {QStringLiteral("u"), 30, right},
                            {Report::tr("unit"), 16, right}});
  table.head();
  for (const EffectEstimate& estimate : effects) {
    const int decimals = decimalsFor(estimate.sigma);
    table.row({effectText(estimate), numberText(estimate.value, decimals),
               numberText(estimate.sigma, decimals), effectUnitText(estimate)});
  }
  table.finish();
}

QString errorText(const InstrumentError& error) {
  return withStandardUncertainty(error.value.arcseconds(), error.sigma.arcseconds(), QStringLiteral("″"));
}

/// A sentence on the instrument errors from the differences of the faces.
void addTwoFaces(ReportSheet& sheet, const TwoFaces& faces) {
  QStringList parts{Report::tr("collimation c = %1").arg(errorText(faces.collimation))};
  if (faces.trunnionTilt) parts << Report::tr("trunnion tilt i = %1").arg(errorText(*faces.trunnionTilt));
  parts << Report::tr("vertical index j = %1").arg(errorText(faces.index));
  const QString visits = QString::number(faces.visits.size()), errors = Report::list(parts);
  sheet.skip(1);
  if (faces.horizontal.degreesOfFreedom > 0 && faces.vertical.degreesOfFreedom > 0)
    sheet.paragraph(Report::tr("Both faces, %1 visits: %2; scatter against the stated σ: horizontal × %3, "
                               "vertical × %4.")
                        .arg(visits, errors, numberText(faces.horizontal.ratio(), 2),
                             numberText(faces.vertical.ratio(), 2)));
  else
    //: %2: errors of the instrument, "collimation c = −3.2″ (u 0.4)"
    sheet.paragraph(Report::tr("Both faces, %1 visits: %2.").arg(visits, errors));
}

/// The parts of the front page's frame, each with its height.
class VerdictFrame {
 public:
  explicit VerdictFrame(ReportSheet& sheet) : m_sheet(sheet) {}

  void add(const QString& text, const TextStyle& style) {
    if (text.isEmpty()) return;
    const QStringList lines = m_sheet.lines(text, style, inner);
    m_parts.push_back({lines.size() * m_sheet.lineHeight(style) + gap, [this, lines, style](double top) {
                         for (const QString& line : lines) {
                           m_sheet.text(line, style, inset, top, inner);
                           top += m_sheet.lineHeight(style);
                         }
                       }});
  }
  /// On one line, the second at the right, if both fit there.
  void addBeside(const QString& first, const QString& second, const TextStyle& style) {
    constexpr double apart = 6;
    if (first.isEmpty() ||
        m_sheet.textWidth(first, style) + apart + m_sheet.textWidth(second, style) > inner) {
      add(first, style);
      add(second, style);
      return;
    }
    m_parts.push_back({m_sheet.lineHeight(style) + gap, [this, first, second, style](double top) {
                         m_sheet.text(first, style, inset, top, inner);
                         m_sheet.text(second, style, inset, top, inner, Qt::AlignRight);
                       }});
  }
  void add(const ToleranceScale& scale) {
    constexpr double height = 7;
    m_parts.push_back({height, [this, scale](double top) {
                         const QRectF target = m_sheet.inDeviceUnits({inset, top, inner, height - 1});
                         m_sheet.draw(
                             [scale, target](QPainter& painter) { drawScale(painter, target, scale); });
                       }});
  }
  void draw(double frameWidth) {
    double height = inset;
    for (const Part& part : m_parts) height += part.height;
    m_sheet.skip(3.5);
    m_sheet.keepTogether(height + 2);
    const QRectF box(0, m_sheet.y(), ReportSheet::width, height);
    m_sheet.fill(box, pale);
    m_sheet.outline(box, frameWidth);
    double top = m_sheet.y() + inset / 2;
    for (const Part& part : m_parts) {
      part.draw(top);
      top += part.height;
    }
    m_sheet.skip(height + 1.5);
  }
  bool fits(const QString& text, const TextStyle& style) const {
    return m_sheet.textWidth(text, style) <= inner;
  }

 private:
  struct Part {
    double height;
    std::function<void(double top)> draw;
  };
  static constexpr double inset = 3, inner = ReportSheet::width - 2 * inset, gap = 0.4;

  static void drawScale(QPainter& painter, const QRectF& target, const ToleranceScale& scale) {
    QFont font = type::label.font();
    font.setPixelSize(qRound(0.42 * target.height()));
    paintToleranceScale(painter, target, scale,
                        {.text = Qt::black,
                         .frame = QColor(0x80, 0x80, 0x80),
                         .size = QColor(0x90, 0x90, 0x90),
                         .within = Qt::white,
                         .beyond = QColor(0xd8, 0xd8, 0xd8),
                         .font = font});
  }

  ReportSheet& m_sheet;
  std::vector<Part> m_parts;
};

}  // namespace

void addVerdict(ReportSheet& sheet, const Gap& gap) {
  const bool hasResult = gap.evaluation->fit.intersection.has_value();
  const Headline headline = headlineOf(gap);
  VerdictFrame frame(sheet);
  const QString verdict = qText(headline.verdictAndTolerance());
  if (!frame.fits(verdict, large)) {
    frame.add(hasResult ? qText(headline.nameAndFigure()) : QString(), large);
    frame.add(qText(headline.verdict), large);
    frame.add(qText(headline.tolerance), large);
  } else {
    frame.addBeside(hasResult ? qText(headline.nameAndFigure()) : QString(), verdict, large);
  }
  if (headline.scale) frame.add(*headline.scale);
  for (const Headline::Line& line : headline.lines)
    frame.add(qText(line.text), line.isWarning ? type::body.inBold() : type::body);
  frame.add(findingsLine(gap), type::body.inBold());
  frame.add(qText(headline.sentence), type::label);
  if (hasResult) frame.add(coverageLine(gap, headline), type::label);
  frame.draw(headline.decided == Verdict::Accept ? 0.4 : 0.8);
}

void addProblems(ReportSheet& sheet, const Evaluation& evaluation) {
  if (evaluation.examined.problems.empty()) return;
  const TextStyle style = type::body.inBold().inColour(red);
  sheet.heading(Report::tr("Entries that could not be used"));
  const auto bar = [&](double top, double bottom) { sheet.rule(0.5, top, 0.5, bottom, 1, red); };
  for (const Problem& problem : evaluation.examined.problems) {
    const QStringList lines =
        sheet.lines(problemText(evaluation.session, problem), style, ReportSheet::width - 4);
    const double height = lines.size() * sheet.lineHeight(style);
    sheet.keepTogether(height);
    if (&problem != &evaluation.examined.problems.front()) sheet.mayBreak();
    bar(sheet.y(), sheet.y() + height);
    for (const QString& line : lines) {
      sheet.text(line, style, 4, sheet.y(), ReportSheet::width - 4);
      sheet.skip(sheet.lineHeight(style));
    }
  }
}

void addResult(ReportSheet& sheet, const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const SessionFit& fit = evaluation.fit;
  sheet.heading(Report::tr("Arc centres and radii"));
  if (fit.arcs.empty()) {
    sheet.paragraph(Report::tr("No arc could be fitted."));
    return;
  }
  addArcs(sheet, fit);
  QStringList units{
      Report::tr("Lengths in mm; u: standard uncertainty, scaled by s0 = %1; n: sightings; rms: "
                 "of all residuals; χ²/f: with the stated σ; f: redundancy.")
          .arg(numberText(fit.noise.factor, 2))};
  if (hasRepeats(*evaluation.examined.measurement))
    units.append(
        Report::tr("Positions at the same axis have one centre and radius, which their f leave out."));
  sheet.paragraph(Report::sentences(units), type::small);
  addEffects(sheet, fit.effects);
  if (evaluation.twoFaces) addTwoFaces(sheet, *evaluation.twoFaces);
  if (!fit.intersection) return;
  sheet.skip(1);
  const QString inPlane =
      Report::tr("Half the distance of the centres in the plane, |O1 − O2|/2 = %1.")
          .arg(valueWithUncertainty(fit.intersection->inPlane, fit.intersection->inPlaneExpanded,
                                    QStringLiteral("mm")));
  sheet.paragraph(inPlane);
}

void addUncertainty(ReportSheet& sheet, const Gap& gap) {
  const auto& fitted = gap.evaluation->fit.intersection;
  if (!fitted) return;
  if (gap.measured()) addStatement(sheet, measuredBudget(*gap.diagnosis, fitted->coverage));
  addStatement(sheet, fitBudget(*fitted));
}

}  // namespace alidade::ui

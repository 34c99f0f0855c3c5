#include "ui/report/report_parts.h"

#include <QPainter>
#include <algorithm>
#include <functional>

#include "core/evaluation/evaluation.h"
#include "core/statement/arcs.h"
#include "core/statement/budget.h"
#include "core/statement/headline.h"
#include "core/statement/two_faces.h"
#include "ui/charts/plotting/tolerance_picture.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/text/accessible_place.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

const QColor red(0xb0, 0x00, 0x20);
const QColor pale(0xf2, 0xf2, 0xf2);
const TextStyle large{.points = 15, .bold = true};

/// The number of findings with a reference, so that no verdict is read without its findings; empty: none.
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
  /// Adds both texts on one line, the second at the right, or the second below the first if they do not fit.
  void addOnOneLine(const QString& first, const QString& second, const TextStyle& style) {
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
    frame.addOnOneLine(hasResult ? qText(headline.nameAndFigure()) : QString(), verdict, large);
  }
  if (headline.scale) frame.add(*headline.scale);
  for (const Headline::Line& line : headline.lines)
    frame.add(qText(line.text), line.isWarning ? type::body.inBold() : type::body);
  frame.add(findingsLine(gap), type::body.inBold());
  frame.add(qText(headline.sentence), type::label);
  if (hasResult)
    frame.add(qText(coverageSentences(gap.evaluation->fit, gap.found(), headline.fitOnly)), type::label);
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
  if (fit.arcs.empty()) {
    sheet.heading(Report::tr("Arc centres and radii"));
    sheet.paragraph(Report::tr("No arc could be fitted."));
    return;
  }
  addStatement(sheet, arcTable(fit));
  addStatement(sheet, effectTable(fit.effects));
  if (evaluation.twoFaces) addStatement(sheet, instrumentErrors(*evaluation.twoFaces));
}

void addUncertainty(ReportSheet& sheet, const Gap& gap) {
  const auto& fitted = gap.evaluation->fit.intersection;
  if (!fitted) return;
  if (gap.measured()) addStatement(sheet, measuredBudget(*gap.diagnosis, fitted->coverage));
  addStatement(sheet, fitBudget(gap.evaluation->fit));
}

}  // namespace alidade::ui

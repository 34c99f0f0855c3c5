#include "ui/panels/result/result_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/tolerance_bar.h"
#include "ui/panels/result/axis_misfit.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/result/headline_lines.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// The value with u in brackets, as the captions say; to a tenth of a micrometre.
QString figureAndU(double value, double u) {
  const int decimals = std::min(decimalsFor(u), 4);
  return QStringLiteral("%1 (%2)").arg(numberText(value, decimals), numberText(u, decimals));
}

/// A tool tip with a line for each repeat of an axis angle.
template <typename Figure>
QString eachPosition(const SessionFit& fit, Figure figure) {
  QString text;
  bool comesAgain = false;
  for (const ArcFit& arc : fit.arcs) {
    comesAgain = comesAgain || arc.time > 1;
    text += u'\n' + positionText(arc.axisDeg, arc.time) + QStringLiteral(": ") + figure(arc);
  }
  return comesAgain ? text : QString();
}

/// Without a result the panel says what is missing instead.
bool hasResult(const Headline& headline) {
  return !headline.fitOnly.empty();
}

/// An accepted or rejected result has its reason in the fold; otherwise the reason is what the reader needs.
bool isReasonFolded(const Headline& headline) {
  return headline.decided && *headline.decided != Verdict::Undecided;
}

QString iconOf(const std::optional<Verdict>& verdict) {
  return verdict ? qText(verdictName(*verdict)) : QStringLiteral("none");
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent)
    : ScrollPage(tr("Result"), parent),
      m_head(new QWidget),
      m_value(wrappedLabel()),
      m_badgeIcon(new QLabel),
      m_badge(new QLabel),
      m_tolerance(wrappedLabel()),
      m_bar(new ToleranceBar),
      m_reason(wrappedLabel()),
      m_lines(new HeadlineLines),
      m_missing(wrappedLabel()),
      m_more(new QToolButton),
      m_details(wrappedLabel()),
      m_arcs(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_compare(new QCheckBox(tr("&Compare with published method"))),
      m_comparison(new QWidget),
      m_published(new FigureGrid) {
  QFont bold = font();
  bold.setBold(true);
  for (QLabel* large : {m_value, m_badge}) large->setFont(bold);
  scaleFont(*m_value, 1.5);
  scaleFont(*m_badge, 1.25);
  m_badge->setWordWrap(true);

  layOutHead();
  QVBoxLayout* layout = column();
  layout->addWidget(m_head);
  layout->addWidget(panelHeading(tr("Arcs")));
  layout->addWidget(m_arcs);
  layout->addSpacing(8);
  layout->addWidget(m_compare);
  auto* comparison = new QVBoxLayout(m_comparison);
  comparison->setContentsMargins(0, 0, 0, 0);
  auto* caution = wrappedLabel();
  caution->setText(
      tr("As printed: y points down for zenith angles, ΔR is the last increment, θ are no tilts. "
         "The method takes tan e = y/L, which no theodolite reads; do not accept by it."));
  caution->setForegroundRole(QPalette::PlaceholderText);
  comparison->addWidget(m_published);
  comparison->addWidget(caution);
  layout->addWidget(m_comparison);
  layout->addStretch();
  m_comparison->hide();
  connect(m_lines, &HeadlineLines::gapActivated, this, &ResultPanel::gapActivated);
  connect(m_compare, &QCheckBox::toggled, m_comparison, &QWidget::setVisible);
  layOutByFont(*this, [this] { settleWidth(); });
  setHeadline(headlineOf(Evaluation()));
  setEvaluation({});
}

void ResultPanel::layOutHead() {
  auto* layout = new QVBoxLayout(m_head);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_value);
  auto* badgeRow = new QHBoxLayout;
  badgeRow->addWidget(m_badgeIcon);
  badgeRow->addWidget(m_badge, 1);
  layout->addLayout(badgeRow);
  m_more->setText(tr("Details"));
  m_more->setCheckable(true);
  m_more->setAutoRaise(true);
  m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  for (QWidget* part :
       std::initializer_list<QWidget*>{m_tolerance, m_bar, m_reason, m_lines, m_missing, m_more, m_details})
    layout->addWidget(part);
  layout->addStretch();
  const auto fold = [this](bool isOpen) {
    m_more->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
    m_details->setVisible(isOpen && !m_more->isHidden());
  };
  connect(m_more, &QToolButton::toggled, this, fold);
  fold(false);
}

void ResultPanel::setComparisonShown(bool shown) {
  m_compare->setChecked(shown);
}

void ResultPanel::setHeadline(const Headline& headline) {
  m_isProvisional = headline.isProvisional;
  if (!m_isProvisional) m_head->setMinimumHeight(0);
  m_value->setText(qText(headline.nameAndFigure()));
  m_value->setToolTip(qText(headline.tip));
  m_tolerance->setText(qText(headline.tolerance));
  m_tolerance->setVisible(!headline.tolerance.empty());
  m_bar->setScale(headline.scale, m_isProvisional);
  m_lines->setLines(headline.lines);
  showVerdict(headline);
  showDetails(headline);
}

void ResultPanel::clearGap() {
  m_head->setMinimumHeight(0);
}

/// The contents below stay where they are.
void ResultPanel::setGapStale() {
  m_head->setMinimumHeight(m_head->height());
}

void ResultPanel::setEvaluation(const Evaluation& evaluation) {
  m_missing->setText(evaluation.fit.intersection ? QString() : whatIsMissing(evaluation));
  m_missing->setVisible(!evaluation.fit.intersection);
  showArcs(evaluation.fit);
  showComparison(evaluation);
}

void ResultPanel::setSearched(const Evaluation& evaluation) {
  showComparison(evaluation);
}

/// Wide enough for figures of usual size and for the longest with wrapped captions. Set once, so that edits
/// do not resize the window.
void ResultPanel::settleWidth() {
  const auto widthOf = [](FigureGrid& grid, const QString& caption, const QString& figure) {
    grid.setRows({tr("0°"), tr("180°")}, {{caption, {figure, figure}}});
    return grid.minimumSizeHint().width();
  };
  FigureGrid onOneLine, wrapped(nullptr, FigureGrid::Captions::Wrapped);
  const int figures = std::max(widthOf(onOneLine, tr("|O1 − O2|/2  mm"), QStringLiteral("400.123 (0.123)")),
                               widthOf(wrapped, tr("Redundancy"), QStringLiteral("400.1234 (0.1234)")));
  const QMargins margins = widget()->layout()->contentsMargins();
  const int bar = verticalScrollBar()->sizeHint().width();
  const int value =
      QFontMetrics(m_value->font()).horizontalAdvance(QStringLiteral("Δd = −2.167 ± 0.042 mm")) + 4;
  setMinimumWidth(std::max(value, figures) + margins.left() + margins.right() + bar + 2 * frameWidth());
}

void ResultPanel::showDetails(const Headline& headline) {
  const bool isFolded = isReasonFolded(headline);
  m_reason->setText(isFolded || !hasResult(headline) ? QString() : unbroken(qText(headline.sentence)));
  m_reason->setVisible(!m_reason->text().isEmpty());
  QStringList lines{qText(headline.fitOnly), qText(headline.fitOnlyDetails)};
  if (isFolded) lines.prepend(qText(headline.sentence));
  lines.removeAll(QString());
  QString text = unbroken(lines.join(u'\n'));
  text.replace(QStringLiteral("u = "), QStringLiteral("u%1=%1").arg(QChar(QChar::Nbsp)));
  m_details->setText(text);
  m_more->setVisible(!lines.isEmpty());
  m_details->setVisible(!lines.isEmpty() && m_more->isChecked());
}

QString ResultPanel::whatIsMissing(const Evaluation& evaluation) {
  if (evaluation.failure) return qText(sentencesOf(*evaluation.failure));
  const auto& problems = evaluation.examined.problems;
  const bool wrong = std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
    return !isMissing(evaluation.session, problem.where);
  });
  if (wrong) return tr("Some entries cannot be used. They are marked and listed with the reason.");
  if (!evaluation.fit.arcs.empty()) {
    return tr("Δd needs both arcs: type the pointing zero and at least three readings at 0° and at 180°.");
  }
  return tr(
      "Type the distance L, the nominal radius R0, the pointing zeros and at least three readings of the arc "
      "at 0° and at 180°.");
}

void ResultPanel::showVerdict(const Headline& headline) {
  m_state = stateOf(headline);
  m_badge->setText(hasResult(headline) ? qText(headline.verdict) : tr("No result"));
  if (const QString icon = iconOf(headline.decided); m_iconName != icon) {
    m_iconName = icon;
    m_badgeIcon->setPixmap(themeIcon(m_iconName).pixmap(24, 24));
  }
  colorHeadline();
}

/// Grey marks a figure that is not the result.
void ResultPanel::colorHeadline() {
  const auto colour = [&](QLabel* label, const QColor& text) {
    QPalette coloured = palette();
    coloured.setColor(QPalette::WindowText, text);
    label->setPalette(coloured);
  };
  colour(m_badge, stateColor(palette(), m_state));
  colour(m_value,
         m_isProvisional ? stateColor(palette(), State::Quiet) : palette().color(QPalette::WindowText));
}

void ResultPanel::showArcs(const SessionFit& fit) {
  const ArcFit* arcs[] = {fit.arcAt(0), fit.arcAt(180)};
  const auto figures = [&](auto&& figure) {
    QStringList texts;
    for (const ArcFit* arc : arcs) {
      const auto i = static_cast<std::size_t>(arc ? arc - fit.arcs.data() : 0);
      texts.append(arc ? figure(*arc, i < fit.sigmas.size() ? fit.sigmas[i] : ArcSigma{}) : notStated());
    }
    return texts;
  };
  const auto misfits = [&](auto&& figure) {
    return figures([&](const ArcFit& arc, const ArcSigma&) { return figure(misfitAt(fit, arc.axisDeg)); });
  };
  const QVector<FigureGrid::Row> rows = {
      {tr("Δx (u)  mm"),
       figures([](const ArcFit& a, const ArcSigma& s) { return figureAndU(a.circle.x, s.x); }),
       tr("Centre of the arc, right positive, with its standard uncertainty")},
      {tr("Δy (u)  mm"),
       figures([](const ArcFit& a, const ArcSigma& s) { return figureAndU(a.circle.y, s.y); }),
       tr("Centre of the arc, up positive, with its standard uncertainty")},
      {tr("R (u)  mm"),
       figures([](const ArcFit& a, const ArcSigma& s) { return figureAndU(a.circle.radius, s.radius); }),
       tr("Fitted radius with its standard uncertainty")},
      {tr("Residual rms  ″"), misfits([](const AxisMisfit& m) { return numberText(m.residualRms, 2); }),
       tr("Root mean square of the residuals of all readings of the arc") +
           eachPosition(fit, [](const ArcFit& a) { return numberText(a.residualRms, 2); })},
      {tr("Reduced χ²"), misfits([](const AxisMisfit& m) {
         return m.degreesOfFreedom > 0 ? numberText(m.reducedChiSquare(), 2) : notStated();
       }),
       tr("About 1 where the readings scatter as stated")},
      {tr("Sightings used"), misfits([](const AxisMisfit& m) { return QString::number(m.sightings); }),
       eachPosition(fit, [](const ArcFit& a) { return QString::number(a.residuals.size()); }).trimmed()},
      {tr("Redundancy"),
       misfits([](const AxisMisfit& m) { return QString::number(m.degreesOfFreedom); }),
       {}},
      {tr("|O1 − O2|/2 (u)  mm"),
       {{},
        fit.intersection ? figureAndU(fit.intersection->inPlane, fit.intersection->inPlaneSigma)
                         : notStated()},
       tr("Half the distance of the centres in the plane of the arc, with its standard uncertainty")},
  };
  m_arcs->setRows({tr("0°"), tr("180°")}, rows);
}

void ResultPanel::showComparison(const Evaluation& evaluation) {
  const PublishedSessionFit& published = evaluation.published;
  const auto figures = [&](double AsPrinted::*figure, int decimals) {
    QStringList texts;
    for (const int axisDeg : {0, 180}) {
      double sum = 0, count = 0;  // the mean over repeats, as Δd uses
      for (const PublishedFit& arc : published.arcs) {
        if (arc.arc.axisDeg != axisDeg) continue;
        sum += arc.asPrinted.*figure;
        ++count;
      }
      texts.append(count > 0 ? numberText(sum / count, decimals) : notStated());
    }
    return texts;
  };
  const QString printed =
      published.intersectionAsPrinted ? numberText(*published.intersectionAsPrinted, 3) : notStated();
  const QString yUp = published.intersection ? numberText(*published.intersection, 3) : notStated();
  m_published->setRows({tr("0°"), tr("180°")}, {{tr("Δx  mm"), figures(&AsPrinted::x, 3)},
                                                {tr("Δy  mm"), figures(&AsPrinted::y, 4)},
                                                {tr("ΔR  mm"), figures(&AsPrinted::deltaRadius, 4)},
                                                {tr("Δθx  rad"), figures(&AsPrinted::thetaX, 5)},
                                                {tr("Δθy  rad"), figures(&AsPrinted::thetaY, 5)},
                                                {tr("Δd as printed  mm"), {{}, printed}},
                                                {tr("Δd with y up  mm"), {{}, yUp}}});
}

void ResultPanel::changeEvent(QEvent* event) {
  ScrollPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorHeadline();
}

}  // namespace alidade::ui

#include "ui/panels/result/result_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/statement/arcs.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/panels/parts/tolerance_bar.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/result/headline_lines.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// True if there is a result. Without a result, the panel says what is missing.
bool hasResult(const Headline& headline) {
  return !headline.fitOnly.empty();
}

/// True if the fold hides the reason of the verdict. Without a decided verdict, the reason is always shown.
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
      m_arcs(new StatementView),
      m_compare(new QCheckBox(tr("&Compare with published method"))),
      m_comparison(new QWidget),
      m_published(new StatementView) {
  QFont bold = font();
  bold.setBold(true);
  for (QLabel* large : {m_value, m_badge}) large->setFont(bold);
  scaleFont(*m_value, 1.5);
  scaleFont(*m_badge, 1.25);
  m_badge->setWordWrap(true);

  layOutHead();
  QVBoxLayout* layout = column();
  layout->addWidget(m_head);
  layout->addWidget(m_arcs);
  layout->addSpacing(8);
  layout->addWidget(m_compare);
  auto* comparison = new QVBoxLayout(m_comparison);
  comparison->setContentsMargins(0, 0, 0, 0);
  comparison->addWidget(m_published);
  layout->addWidget(m_comparison);
  layout->addStretch();
  m_comparison->hide();
  connect(m_lines, &HeadlineLines::gapActivated, this, &ResultPanel::gapActivated);
  connect(m_compare, &QCheckBox::toggled, m_comparison, &QWidget::setVisible);
  layOutByFont(*this, [this] { fixWidth(); });
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

/// Keeps the height of the head, so that the contents below do not move.
void ResultPanel::setGapStale() {
  m_head->setMinimumHeight(m_head->height());
}

void ResultPanel::setEvaluation(const Evaluation& evaluation) {
  m_missing->setText(evaluation.fit.intersection ? QString() : whatIsMissing(evaluation));
  m_missing->setVisible(!evaluation.fit.intersection);
  m_arcs->setStatement(transposed(arcTable(evaluation.fit)));
  setSearched(evaluation);
}

void ResultPanel::setSearched(const Evaluation& evaluation) {
  m_published->setStatement(transposed(publishedTable(evaluation.published)));
}

/// Sets a minimum width for figures of usual size, and for the longest figures with wrapped captions. Called
/// once, so that edits do not resize the window.
void ResultPanel::fixWidth() {
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
  const int whole = std::max(value, figures) + margins.left() + margins.right() + bar + 2 * frameWidth();
  setMinimumWidth(withinScreen(*this, whole, 370, 33));
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

/// Shows a provisional figure in grey.
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

void ResultPanel::changeEvent(QEvent* event) {
  ScrollPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorHeadline();
}

}  // namespace alidade::ui

#include "ui/entry/bench_display.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "core/evaluation/guide.h"
#include "core/session/entry.h"
#include "core/statement/sighting_choice.h"
#include "ui/panels/parts/tolerance_bar.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// Letter height of each line as a share of the window's height.
constexpr double placeShare = 0.10, anglesShare = 0.17, resultShare = 0.11, verdictShare = 0.08,
                 lastShare = 0.055, smallShare = 0.045;

void setHeight(QLabel& label, double pixels) {
  QFont font = label.font();
  font.setPixelSize(std::max(8, static_cast<int>(pixels)));
  label.setFont(font);
}

void setColour(QLabel& label, const QColor& colour) {
  QPalette coloured = label.palette();
  coloured.setColor(QPalette::WindowText, colour);
  label.setPalette(coloured);
}

/// Sets the letter height, or a smaller one at which the text is at most `width` pixels wide.
void setHeightWithin(QLabel& label, double pixels, int width) {
  setHeight(label, pixels);
  const int wide = label.sizeHint().width();
  if (wide > width && width > 0) setHeight(label, pixels * width / wide);
}

}  // namespace

BenchDisplay::BenchDisplay(QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_place(new QLabel),
      m_angles(new QLabel),
      m_last(new QLabel),
      m_result(new QLabel),
      m_verdict(new QLabel),
      m_below(new QLabel),
      m_bar(new ToleranceBar) {
  setWindowTitle(tr("Large Display"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 16, 24, 16);
  for (QLabel* label : {m_place, m_angles, m_last, m_result, m_verdict, m_below}) {
    label->setAlignment(Qt::AlignCenter);
    label->setTextInteractionFlags(Qt::NoTextInteraction);
    layout->addWidget(label, label == m_angles ? 2 : 1);
    if (label == m_verdict) layout->addWidget(m_bar);
  }
  m_place->setAccessibleName(tr("Next entry"));
  m_angles->setAccessibleName(tr("Expected reading"));
  m_last->setAccessibleName(tr("Reading entered last"));
  m_result->setAccessibleName(tr("Result so far"));
  m_verdict->setAccessibleName(tr("Tolerance and verdict"));
  m_below->setAccessibleName(tr("Notes on the verdict"));
  for (QLabel* sentence : {m_last, m_below}) sentence->setWordWrap(true);
  QFont bold = m_angles->font();
  bold.setBold(true);
  m_angles->setFont(bold);
  resize(900, 560);
  setMinimumSize(320, 220);
}

void BenchDisplay::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  refresh();
}

void BenchDisplay::setHeadline(const Headline& headline) {
  m_headline = headline;
  refresh();
}

void BenchDisplay::setPosition(std::size_t position) {
  m_position = position;
  refresh();
}

void BenchDisplay::setDoubt(const QString& doubt) {
  m_doubt = doubt;
  refresh();
}

void BenchDisplay::refresh() {
  if (isHidden() || !m_evaluation) return;
  const Session& session = m_evaluation->session;
  const CircleUnit unit = circleUnitOf(session);
  const auto next = entryToLeadTo(*m_evaluation, m_position);
  m_place->setText(next ? entryText(session, *next) : tr("All readings are taken"));
  const auto expected = next ? expectedOf(*m_evaluation, *next) : std::nullopt;
  m_angles->setText(expected ? tr("%1   %2").arg(coarseAngleText(expected->horizontal, unit),
                                                 coarseAngleText(expected->vertical, unit))
                             : QString());
  m_angles->setVisible(expected.has_value());
  const Guide* guide = m_evaluation->guide.get();
  const bool isDone = m_doubt.isEmpty() && guide && guide->choice && isEnough(guide->choice->soFar);
  m_last->setText(isDone ? qText(enoughSentence(guide->choice->soFar)) : m_doubt);
  setColour(*m_last, stateColor(palette(), isDone ? State::Quiet : State::Bad));
  showHeadline();
  fitText();
}

void BenchDisplay::showHeadline() {
  m_result->setText(qText(m_headline.nameAndFigure()));
  setColour(*m_result, m_headline.isProvisional ? stateColor(palette(), State::Quiet)
                                                : palette().color(QPalette::WindowText));
  m_verdict->setText(qText(m_headline.verdictAndTolerance()));
  setColour(*m_verdict, stateColor(palette(), stateOf(m_headline)));
  m_bar->setScale(m_headline.scale, m_headline.isProvisional);
  QStringList lines;
  for (const Headline::Line& line : m_headline.lines) lines.append(unbroken(qText(line.text)));
  m_below->setText(lines.join(u'\n'));
  const bool isWarned = std::ranges::any_of(m_headline.lines, &Headline::Line::isWarning);
  setColour(*m_below, stateColor(palette(), isWarned ? State::Open : State::Quiet));
}

void BenchDisplay::fitText() {
  const int width = contentsRect().width() - 48;
  setHeightWithin(*m_place, placeShare * height(), width);
  setHeightWithin(*m_angles, anglesShare * height(), width);
  setHeightWithin(*m_result, resultShare * height(), width);
  setHeightWithin(*m_verdict, verdictShare * height(), width);
  setHeight(*m_below, smallShare * height());
  setHeight(*m_last, lastShare * height());
}

void BenchDisplay::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void BenchDisplay::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitText();
}

void BenchDisplay::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return void(close());
  QWidget* window = parentWidget();
  window->activateWindow();
  QWidget* entry = window->focusWidget() ? window->focusWidget() : window;
  QCoreApplication::sendEvent(entry, event);
}

}  // namespace alidade::ui

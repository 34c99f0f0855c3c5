#include "ui/panels/gap/gap_headline.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include "core/statement/gap.h"
#include "core/wording/findings.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

QString iconOf(State state) {
  switch (state) {
    case State::Good:
      return QStringLiteral("accept");
    case State::Bad:
      return QStringLiteral("problem");
    case State::Open:
      return QStringLiteral("warning");
    case State::Quiet:
      break;
  }
  return QStringLiteral("none");
}

}  // namespace

GapHeadline::GapHeadline(QWidget* parent)
    : QWidget(parent), m_icon(new QLabel), m_headline(wrappedLabel()), m_sentence(wrappedLabel()) {
  QFont large = font();
  large.setBold(true);
  m_headline->setFont(large);
  scaleFont(*m_headline, 1.25);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setVerticalSpacing(3);
  layout->addWidget(m_icon, 0, 0);
  layout->addWidget(m_headline, 0, 1);
  layout->addWidget(m_sentence, 1, 0, 1, 2);
  layout->setColumnStretch(1, 1);
  layout->setRowStretch(2, 1);
}

void GapHeadline::setGap(const Gap& gap) {
  if (!gap.diagnosis) return setText(tr("No diagnosis"), qText(reasonForNone(gap)));
  const bool isUnknown = gap.diagnosis->verdict == DiagnosisVerdict::NotInCatalogue;
  const Statement verdict = gapVerdict(gap);
  std::string sentences;
  for (const std::string& sentence : verdict.sentences) sentences = inTurn(sentences, sentence);
  m_headline->setText(qText(verdict.title));
  m_sentence->setText(qText(sentences));
  setState(!gap.isOpen() ? State::Good : isUnknown ? State::Bad : State::Open);
}

void GapHeadline::setText(const QString& headline, const QString& sentence, State state) {
  m_headline->setText(headline);
  m_sentence->setText(sentence);
  setState(state);
}

void GapHeadline::setState(State state) {
  m_state = state;
  m_icon->setPixmap(themeIcon(iconOf(state)).pixmap(22, 22));
  color();
}

void GapHeadline::color() {
  QPalette colored = palette();
  colored.setColor(QPalette::WindowText, stateColor(palette(), m_state));
  m_headline->setPalette(colored);
}

void GapHeadline::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) color();
}

}  // namespace alidade::ui

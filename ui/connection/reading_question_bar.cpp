#include "ui/connection/reading_question_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/connection/reading_flow.h"
#include "ui/settings/theme.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int bannerIcon = 16;  // pixels

}  // namespace

ReadingQuestionBar::ReadingQuestionBar(ReadingFlow& flow, QWidget* parent)
    : QFrame(parent),
      m_flow(flow),
      m_icon(new QLabel),
      m_text(new QLabel),
      m_take(new QPushButton(tr("Take It"))),
      m_discard(new QPushButton(tr("Do Not Take It"))) {
  setFrameShape(StyledPanel);
  setAccessibleName(tr("Questionable reading of the instrument"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_take->setObjectName(QStringLiteral("take questioned reading"));
  m_take->setToolTip(tr("Enters the reading unchanged; the cell stays marked with the expected value"));
  m_discard->setObjectName(QStringLiteral("discard questioned reading"));
  m_discard->setToolTip(
      tr("The reading stays in the connection log. Point at the right target and read again"));
  auto* says = new QHBoxLayout;
  says->addWidget(m_icon, 0, Qt::AlignTop);
  says->addWidget(m_text, 1);
  auto* does = new QHBoxLayout;
  does->addWidget(m_take);
  does->addWidget(m_discard);
  does->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(5);
  layout->addLayout(says);
  layout->addLayout(does);
  connect(m_take, &QPushButton::clicked, &m_flow, &ReadingFlow::takeAnyway);
  connect(m_discard, &QPushButton::clicked, &m_flow, &ReadingFlow::discard);
  connect(&m_flow, &ReadingFlow::questionChanged, this, &ReadingQuestionBar::showQuestion);
  showQuestion();
}

void ReadingQuestionBar::showQuestion() {
  const QString question = visibleLine(m_flow.question());
  const auto behind = m_flow.waiting() > 1 ? m_flow.waiting() - 1 : 0;
  m_text->setText(behind == 0 ? question : tr("%1 Further readings waiting: %2.").arg(question).arg(behind));
  m_icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(bannerIcon, bannerIcon));
  setVisible(!question.isEmpty());
}

void ReadingQuestionBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && isVisible()) showQuestion();
}

}  // namespace alidade::ui

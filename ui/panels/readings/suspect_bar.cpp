#include "ui/panels/readings/suspect_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/session/entry.h"
#include "core/wording/suspects.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/proposal_text.h"

namespace alidade::ui {

SuspectBar::SuspectBar(QWidget* parent)
    : QFrame(parent),
      m_text(new QLabel),
      m_buttons(new QWidget),
      m_use(new QPushButton),
      m_others(new QToolButton),
      m_exclude(new QPushButton(tr("Exclude row"))),
      m_count(new QLabel),
      m_next(new QToolButton) {
  setFrameShape(StyledPanel);
  setAccessibleName(tr("Readings that look misread"));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* icon = new QLabel;
  icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
  auto* says = new QHBoxLayout;
  says->addWidget(icon, 0, Qt::AlignTop);
  says->addWidget(m_text, 1);
  auto* does = new QHBoxLayout(m_buttons);
  does->setContentsMargins(0, 0, 0, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_use, m_others, m_exclude}) does->addWidget(part);
  does->addStretch();
  does->addWidget(m_count);
  does->addWidget(m_next);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(5);
  layout->addLayout(says);
  layout->addWidget(m_buttons);
  createButtons();
  hide();
}

void SuspectBar::createButtons() {
  m_use->setObjectName(QStringLiteral("use proposal"));
  m_use->setIcon(themeIcon(QStringLiteral("accept")));
  m_others->setObjectName(QStringLiteral("other proposals"));
  m_others->setText(tr("Other"));
  m_others->setToolTip(tr("Other possible readings"));
  m_others->setFocusPolicy(Qt::StrongFocus);
  m_others->setPopupMode(QToolButton::InstantPopup);
  m_others->setMenu(new QMenu(m_others));
  m_exclude->setObjectName(QStringLiteral("exclude suspect"));
  m_exclude->setToolTip(tr("Keeps the row, but takes it out of the fit"));
  m_next->setText(tr("Next (F7)"));
  m_next->setToolTip(tr("Goes to the reading in the table; pressed again, to the next"));
  m_next->setFocusPolicy(Qt::StrongFocus);
  connect(m_use, &QPushButton::clicked, this, [this] { useProposal(); });
  connect(m_exclude, &QPushButton::clicked, this, &SuspectBar::exclude);
  connect(m_next, &QToolButton::clicked, this, &SuspectBar::goToNext);
}

void SuspectBar::setStale() {
  if (std::exchange(m_isStale, true)) return;
  m_text->setText(tr("Looking for misread readings…"));
  m_buttons->hide();
  if (isVisible()) setFixedHeight(height());
  emit suspectsChanged();
}

void SuspectBar::setUnknown() {
  m_suspects.clear();
  m_isStale = m_isVisited = false;
  m_index = 0;
  showCurrent();
  emit suspectsChanged();
}

/// Keeps the suspect shown if its reading still looks misread.
void SuspectBar::setEvaluation(const Evaluation& evaluation) {
  if (!evaluation.isSearched) return setStale();
  const Place before = m_index < m_suspects.size() ? m_suspects[m_index].where : Place{};
  m_suspects = evaluation.suspects;
  m_unit = circleUnitOf(evaluation.session);
  m_isStale = false;
  const auto same = std::find_if(m_suspects.begin(), m_suspects.end(),
                                 [&](const Suspect& suspect) { return suspect.where == before; });
  m_isVisited = m_isVisited && same != m_suspects.end();
  m_index = same == m_suspects.end() ? 0 : static_cast<std::size_t>(same - m_suspects.begin());
  showCurrent();
  emit suspectsChanged();
}

void SuspectBar::showReading(std::size_t position, std::size_t row) {
  if (m_isStale) return;
  for (std::size_t i = 0; i < m_suspects.size(); ++i) {
    const Place& where = m_suspects[i].where;
    if (where.position != position || where.reading != row) continue;
    const bool isHere = m_index < m_suspects.size() && m_suspects[m_index].where.reading == row &&
                        m_suspects[m_index].where.position == position;
    if (!isHere) m_index = i;
    m_isVisited = true;
    showCurrent();
    emit suspectsChanged();
    return;
  }
}

void SuspectBar::showCurrent() {
  const Suspect* suspect = m_index < m_suspects.size() ? &m_suspects[m_index] : nullptr;
  setMinimumHeight(0);
  setMaximumHeight(QWIDGETSIZE_MAX);
  setVisible(suspect != nullptr);
  if (!suspect) return;
  m_buttons->show();
  m_text->setText(qText(sentenceOf(*suspect)));
  const bool hasMeaning = !suspect->proposals.empty();
  m_use->setVisible(hasMeaning);
  if (hasMeaning) {
    m_use->setText(tr("Use %1 (F8)").arg(proposalText(suspect->proposals.front(), m_unit)));
    m_use->setToolTip(qText(sentenceOf(suspect->proposals.front())));
  }
  fitText();
  fillOthers(*suspect);
  m_count->setText(tr("%1 of %2").arg(m_index + 1).arg(m_suspects.size()));
}

void SuspectBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fitText();
}

/// Sets the minimum height to that of the wrapped text, which a splitter does not compute from the width.
void SuspectBar::fitText() {
  m_text->setMinimumHeight(std::max(0, m_text->heightForWidth(width() - 60)));
}

void SuspectBar::fillOthers(const Suspect& suspect) {
  m_others->menu()->clear();
  for (std::size_t i = 1; i < suspect.proposals.size(); ++i) {
    QAction* action =
        m_others->menu()->addAction(tr("Use %1").arg(proposalText(suspect.proposals[i], m_unit)));
    action->setToolTip(qText(sentenceOf(suspect.proposals[i])));
    connect(action, &QAction::triggered, this, [this, i] { useProposal(static_cast<int>(i)); });
  }
  m_others->menu()->setToolTipsVisible(true);
  m_others->setVisible(suspect.proposals.size() > 1);
}

const Suspect* SuspectBar::current() const {
  return m_isStale || m_index >= m_suspects.size() ? nullptr : &m_suspects[m_index];
}

bool SuspectBar::hasProposal() const {
  return current() && !current()->proposals.empty();
}

void SuspectBar::goToNext() {
  if (!current()) return;
  if (m_isVisited) m_index = (m_index + 1) % m_suspects.size();
  m_isVisited = true;
  showCurrent();
  emit suspectsChanged();
  emit placeActivated(m_suspects[m_index].where);
}

void SuspectBar::useProposal(int index) {
  const Suspect* suspect = current();
  if (!suspect || static_cast<std::size_t>(index) >= suspect->proposals.size()) return;
  const auto changes = suspect->proposals[static_cast<std::size_t>(index)].changes;
  emit changesWanted(changes, tr("Correct point %1").arg(suspect->point));
}

void SuspectBar::exclude() {
  if (const Suspect* suspect = current()) emit exclusionWanted(Place(suspect->where));
}

}  // namespace alidade::ui

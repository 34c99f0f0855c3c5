#include "ui/panels/result/findings_panel.h"

#include <QKeyEvent>
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/evaluation/evaluation.h"
#include "core/wording/findings.h"
#include "ui/document/field.h"
#include "ui/document/known_entry.h"
#include "ui/document/reading_column.h"
#include "ui/settings/theme.h"
#include "ui/text/accessible_place.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Rank by severity, worst first.
int rankOf(const QString& icon) {
  static const QStringList order{QStringLiteral("problem"), QStringLiteral("incomplete"),
                                 QStringLiteral("warning")};
  const auto rank = order.indexOf(icon);
  return static_cast<int>(rank < 0 ? order.size() : rank);
}

}  // namespace

bool isMissing(const Session& session, const Place& place) {
  if (const auto known = knownAt(place)) {
    const KnownSize* size = knownSize(session, known->ref);
    return size && known->member == "sigma" && size->sigma.empty();
  }
  if (!place.position || !place.reading) return fieldNamed(place.field) && fieldText(session, place).empty();
  const Reading& reading = session.positions.at(*place.position).readings.at(*place.reading);
  const auto text = readingText(readingColumn(place.field));
  return text && (reading.*text).empty();
}

FindingsPanel::FindingsPanel(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Problems and findings"));
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  setIconSize({16, 16});
  setResizeMode(Adjust);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { activate(row(item)); });
}

/// Aligns the sign with the first line of its text, since a low list may hide the last line.
void FindingsPanel::initViewItemOption(QStyleOptionViewItem* option) const {
  QListWidget::initViewItemOption(option);
  option->decorationAlignment = Qt::AlignTop | Qt::AlignHCenter;
}

void FindingsPanel::setEvaluation(const Evaluation& evaluation) {
  m_found = entriesOf(evaluation);
  m_isSearched = evaluation.isSearched;
  m_hasSuspects = !evaluation.suspects.empty();
  refresh();
}

void FindingsPanel::setGap(const QString& headline) {
  m_gapState = GapState::Known;
  m_gapHeadline = headline;
  refresh();
}

void FindingsPanel::setGapStale() {
  if (m_gapState != GapState::Known) return;
  m_gapState = m_gapHeadline.isEmpty() ? GapState::Unknown : GapState::Old;
  refresh();
}

void FindingsPanel::clearGap() {
  m_gapState = GapState::Unknown;
  m_gapHeadline.clear();
  m_isSearched = m_hasSuspects = false;
  m_found.clear();
  m_entries.clear();
  clear();
  emit counted({});
  emit listed();
}

int FindingsPanel::wholeHeight() const {
  const int frame = 2 * frameWidth();
  if (count() == 0) return frame;
  return visualItemRect(item(count() - 1)).bottom() - visualItemRect(item(0)).top() + 1 + frame;
}

/// Does not touch an unchanged list, so scroll position and current line stay. A line "No problems." also
/// stays until a new diagnosis.
void FindingsPanel::refresh() {
  std::vector<Entry> entries = m_found;
  if (!m_gapHeadline.isEmpty()) entries.insert(entries.begin(), gapEntry());
  std::ranges::stable_sort(entries, {}, [](const Entry& entry) {
    return entry.isGap ? rankOf(QStringLiteral("warning")) : rankOf(entry.icon);
  });
  const bool isAllKnown = m_isSearched && m_gapState == GapState::Known;
  if (isAllKnown && entries.empty() && !m_hasSuspects)
    entries.push_back({QStringLiteral("accept"), tr("In order"), tr("No problems.")});
  if (entries == m_entries || (entries.empty() && saysSound() && !isAllKnown && !m_hasSuspects)) return;
  clear();
  m_entries = std::move(entries);
  for (const Entry& entry : m_entries) add(entry);
  emit counted(countText());
  emit listed();
}

QString FindingsPanel::countText() const {
  if (m_entries.size() < 2) return {};
  const auto count = [this](const char* icon) {
    return static_cast<int>(std::ranges::count(m_entries, QString::fromLatin1(icon), &Entry::icon));
  };
  QStringList parts;
  const auto append = [&parts](int number, const QString& one, const QString& many) {
    if (number > 0) parts.append(number == 1 ? one : many.arg(number));
  };
  append(count("problem"), tr("1 problem"), tr("%1 problems"));
  append(count("incomplete"), tr("1 missing entry"), tr("%1 missing entries"));
  append(count("warning"), tr("1 warning"), tr("%1 warnings"));
  append(count("note") + count("none"), tr("1 note"), tr("%1 notes"));
  return listText(parts);
}

FindingsPanel::Entry FindingsPanel::gapEntry() const {
  const bool isOld = m_gapState == GapState::Old;
  const QString text =
      isOld ? tr("Before the latest changes: %1.") : tr("Model and readings disagree, see “Gap”. %1.");
  return {.icon = isOld ? QStringLiteral("none") : QStringLiteral("warning"),
          .accessible = isOld ? tr("Before") : tr("Warning"),
          .text = text.arg(m_gapHeadline),
          .isGap = true};
}

std::vector<FindingsPanel::Entry> FindingsPanel::entriesOf(const Evaluation& evaluation) {
  std::vector<Entry> entries = problemEntries(evaluation, false);
  std::ranges::move(problemEntries(evaluation, true), std::back_inserter(entries));
  // Suspects are not listed here, since the suspect bar shows them with their actions.
  for (const Finding& finding : findingsOf(evaluation)) {
    const QString icons[] = {QStringLiteral("note"), QStringLiteral("warning"), QStringLiteral("problem")};
    const QString accessible[] = {tr("Note"), tr("Warning"), tr("Error")};
    const auto severity = static_cast<std::size_t>(finding.severity);
    entries.push_back({icons[severity], accessible[severity], qText(sentencesOf(finding)), finding.where});
  }
  return entries;
}

/// The missing entries if `missing`, else the unusable entries. At most `mostListed`: the table marks all.
std::vector<FindingsPanel::Entry> FindingsPanel::problemEntries(const Evaluation& evaluation, bool missing) {
  const QString icon = missing ? QStringLiteral("incomplete") : QStringLiteral("problem");
  const QString accessible = missing ? tr("Missing") : tr("Problem");
  std::vector<Entry> entries;
  std::size_t further = 0;
  Place next;
  for (const Problem& problem : evaluation.examined.problems) {
    if (isMissing(evaluation.session, problem.where) != missing) continue;
    if (entries.size() < mostListed)
      entries.push_back({icon, accessible, problemText(evaluation.session, problem), problem.where});
    else if (further++ == 0)
      next = problem.where;
  }
  if (further == 0) return entries;
  const QString text =
      missing ? tr("%1 further entries are missing; they are listed once those above are filled in.")
              : tr("%1 further entries cannot be used; they are listed once those above are corrected.");
  entries.push_back({icon, accessible, text.arg(further), next});
  return entries;
}

bool FindingsPanel::saysSound() const {
  return m_entries.size() == 1 && m_entries.front().icon == QStringLiteral("accept");
}

void FindingsPanel::add(const Entry& entry) {
  auto* item = new QListWidgetItem(themeIcon(entry.icon), visibleLine(entry.text), this);
  item->setToolTip(tipText(entry.text));
  item->setData(Qt::AccessibleTextRole, QStringLiteral("%1: %2").arg(entry.accessible, entry.text));
}

void FindingsPanel::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && currentRow() >= 0) {
    activate(currentRow());
  } else {
    QListWidget::keyPressEvent(event);
  }
}

/// A receiver may refill the list, so the entry is a copy.
void FindingsPanel::activate(int row) {
  const Entry entry = m_entries[static_cast<std::size_t>(row)];
  if (entry.isGap)
    emit gapActivated();
  else
    emit placeActivated(entry.place);
}

}  // namespace alidade::ui

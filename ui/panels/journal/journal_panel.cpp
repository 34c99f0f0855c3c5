#include "ui/panels/journal/journal_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "core/wording/journal.h"
#include "ui/panels/parts/data_table.h"
#include "ui/text/journal_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestCell = 200;

}  // namespace

JournalPanel::JournalPanel(QWidget* parent)
    : QWidget(parent),
      m_evaluation(std::make_shared<const Evaluation>()),
      m_summary(new QLabel),
      m_table(createTable()) {
  m_summary->setObjectName(QStringLiteral("journal summary"));
  m_summary->setWordWrap(true);
  m_summary->setTextFormat(Qt::PlainText);
  m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_table->setAccessibleName(tr("Journal of changes"));
  m_table->setPlaceholder(tr("No entry was changed after it was recorded."));
  setFocusProxy(m_table);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_summary);
  layout->addWidget(m_table, 1);
  m_summary->hide();
}

const JournalEntry& JournalPanel::entry(int row) const {
  const auto& journal = m_evaluation->session.journal;
  return journal[journal.size() - 1 - static_cast<std::size_t>(row)];
}

DataTable* JournalPanel::createTable() {
  const auto left = Qt::AlignLeft;
  const auto content = [this](std::string JournalEntry::*member) {
    return [this, member](int row) {
      return shortLine(contentText(entry(row), entry(row).*member), longestCell);
    };
  };
  return new DataTable({
      {tr("When (UTC)"), tr("Universal time"), QStringLiteral("2026-08-28 28:28"),
       [this](int row) { return visibleLine(timeText(entry(row).at)); }, left},
      {tr("What"), tr("Name of the entry at that time"), tr("180°, row 28 (point 28), vertical"),
       [this](int row) { return journalPlace(entry(row)); }, left},
      {tr("From"), tr("Old content"), QStringLiteral("341°52′24.5″"), content(&JournalEntry::from), left},
      {tr("To"), tr("New content"), QStringLiteral("341°52′24.5″"), content(&JournalEntry::to), left},
      {tr("Why"),
       {},
       tr("suggestion accepted"),
       [this](int row) { return shortLine(reasonText(entry(row), m_evaluation->session), longestCell); },
       left},
      {tr("Who"), tr("Operator in the session at that time"), QStringLiteral("J. Doe-Weatherby"),
       [this](int row) { return shortLine(entry(row).by, longestCell); }, left},
  });
}

void JournalPanel::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  m_table->setRows(static_cast<int>(evaluation->session.journal.size()));
}

void JournalPanel::setSummary(const Evaluation& evaluation) {
  m_summary->setText(evaluation.isSearched || evaluation.session.journal.empty()
                         ? visibleLine(evaluation.journal)
                         : tr("Checking the journal…"));
  m_summary->setVisible(!m_summary->text().isEmpty());
}

}  // namespace alidade::ui

#include "ui/dialogs/trial_list.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/parts/data_table.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/trial_text.h"

namespace alidade::ui {

namespace {

QString tallyText(const QString& name, const Tally& tally) {
  const double share =
      tally.count > 0 ? 100.0 * static_cast<double>(tally.hits) / static_cast<double>(tally.count) : 0;
  return TrialList::tr("%1: %2 of %3 (%4 %)")
      .arg(name)
      .arg(tally.hits)
      .arg(tally.count)
      .arg(numberText(share, 0));
}

}  // namespace

TrialList::TrialList(QWidget* parent) : QWidget(parent), m_summary(wrappedLabel()), m_table(createTable()) {
  m_summary->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  layOutByFont(*m_summary,
               [this] { m_summary->setMinimumHeight(2 * m_summary->fontMetrics().lineSpacing()); });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(panelHeading(tr("Score so far")));
  layout->addWidget(m_summary);
  layout->addWidget(m_table, 1);
  showScore();
}

DataTable* TrialList::createTable() {
  const auto of = [this](auto text) { return [this, text](int row) { return text(atRow(row)); }; };
  auto* table = new DataTable(
      {{tr("Trial"), tr("Number of the trial"), QStringLiteral("888888"),
        of([](const Drawn& d) { return qText(d.trial->trial.seal.id); })},
       {tr("Plan"), tr("Plan of readings"), QStringLiteral("there-and-back8"),
        of([](const Drawn& d) { return qText(d.trial->trial.truth.protocol); }), Qt::AlignLeft},
       {tr("Truth"), tr("What was simulated"), tr("vertical circle eccentricity"),
        of([](const Drawn& d) { return d.isOpen ? trialKindName(d.trial->trial.seal.kind) : tr("sealed"); }),
        Qt::AlignLeft},
       {tr("Score"), tr("Whether the diagnosis was right"), tr("wrong"), of([](const Drawn& d) {
          return !d.isOpen ? notStated() : d.trial->score.right ? tr("right") : tr("wrong");
        }),
        Qt::AlignLeft}});
  table->setAccessibleName(tr("Trials drawn"));
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setPlaceholder(tr("Every trial is listed here as it is drawn."));
  table->horizontalHeader()->setStretchLastSection(true);
  connect(table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (!current.isValid()) return;
            m_isFollowing = current.row() == 0 && m_isSeries;
            emit chosen(atRow(current.row()).trial);
          });
  return table;
}

void TrialList::add(const SharedTrial& trial) {
  const bool isFollowing = m_isFollowing;
  const int row = isFollowing ? 0 : m_table->currentIndex().row() + 1;
  m_drawn.push_back({trial, m_isSeries});
  if (m_isSeries) score(*trial);
  m_table->setRows(static_cast<int>(m_drawn.size()));
  m_table->selectDataRows({row});
  m_isFollowing = isFollowing;  // the program, not the user, changed the row
  showScore();
}

void TrialList::openSeal(const SharedTrial& trial) {
  for (Drawn& drawn : m_drawn) {
    if (drawn.trial != trial || drawn.isOpen) continue;
    drawn.isOpen = true;
    score(*trial);
  }
  m_table->setRows(static_cast<int>(m_drawn.size()));
  showScore();
}

bool TrialList::isOpen(const SharedTrial& trial) const {
  return std::any_of(m_drawn.begin(), m_drawn.end(),
                     [&](const Drawn& drawn) { return drawn.trial == trial && drawn.isOpen; });
}

void TrialList::beginDraw(bool isSeries) {
  clearChoice();
  m_isSeries = isSeries;
  m_isFollowing = true;
}

void TrialList::clearChoice() {
  m_table->clearSelection();
  m_table->setCurrentIndex({});
}

void TrialList::score(const DiagnosedTrial& trial) {
  const TrialSummary summary =
      summarise({{.truth = trial.trial.seal, .score = trial.score, .wrongWithout = {}}});
  for (const auto& [trialClass, right] : summary.right) m_right += right;
  m_falseAlarms += summary.falseAlarms;
  m_covered += summary.covered;
}

void TrialList::showScore() {
  QStringList texts;
  if (m_right.count > 0) {
    texts.append(tallyText(tr("Right"), m_right));
    if (m_falseAlarms.count > 0) texts.append(tallyText(tr("false alarms"), m_falseAlarms));
    if (m_covered.count > 0) texts.append(tallyText(tr("Δd ± U covers the truth"), m_covered));
  } else {
    texts.append(tr("No seal was opened yet"));
  }
  if (const std::size_t sealed = m_drawn.size() - m_right.count; sealed > 0)
    texts.append(tr("still sealed: %1").arg(sealed));
  m_summary->setText(texts.join(QStringLiteral("; ")) + u'.');
}

}  // namespace alidade::ui

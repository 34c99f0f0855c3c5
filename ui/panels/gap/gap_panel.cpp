#include "ui/panels/gap/gap_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/statement/gap.h"
#include "ui/charts/gap/closure_bars.h"
#include "ui/charts/gap/gap_map.h"
#include "ui/charts/gap/leftover_strips.h"
#include "ui/panels/gap/form_list.h"
#include "ui/panels/gap/gap_headline.h"
#include "ui/panels/gap/remedy_list.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/settings/window_font.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

constexpr int twoColumnsFrom = 620;

/// Widgets under a heading, as one block of the page.
QWidget* block(const QString& heading, std::initializer_list<QWidget*> parts) {
  auto* frame = new QWidget;
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  QLabel* title = panelHeading(heading);
  title->setWordWrap(true);
  layout->addWidget(title);
  for (QWidget* part : parts) layout->addWidget(part);
  layout->addStretch();
  return frame;
}

/// A note in pale letters below a picture or a switch.
QLabel* standard(const QString& sentence) {
  QLabel* label = wrappedLabel();
  label->setForegroundRole(QPalette::PlaceholderText);
  label->setText(sentence);
  return label;
}

}  // namespace

GapPanel::GapPanel(QWidget* parent)
    : ScrollPage(tr("Gap between model and readings"), parent),
      m_grid(new QGridLayout),
      m_headline(new GapHeadline),
      m_causes(new StatementView),
      m_actions(new QHBoxLayout),
      m_remedies(new RemedyList),
      m_forms(new FormList),
      m_stages(new StatementView),
      m_map(new GapMap),
      m_leftOver(new LeftoverStrips),
      m_candidates(nullptr),
      m_add(nullptr),
      m_closures(new ClosureBars),
      m_closuresNote(wrappedLabel()),
      m_withReference(new QCheckBox(tr("Weigh the causes with the reference"))),
      m_withReferenceNote(standard(tr("Δd itself never depends on the reference."))),
      m_required(new StatementView),
      m_next(new StatementView),
      m_undetectable(new StatementView),
      m_known(new StatementView) {
  setFocusPolicy(Qt::StrongFocus);
  column()->addLayout(m_grid);
  column()->addStretch();
  m_grid->setHorizontalSpacing(22);
  m_grid->setVerticalSpacing(6);
  m_withReference->setObjectName(QStringLiteral("with reference"));
  m_withReference->setToolTip(
      tr("The difference of Δd from the reference then helps to distinguish the causes.\nΔd with the causes "
         "depends on the readings alone, and so does the report."));
  connect(m_forms, &FormList::keepWanted, this,
          [this](std::size_t form) { emit formWanted(m_gap->diagnosis->forms[form]); });
  m_causesBlock = createCauses();
  m_formsBlock = block(tr("Form"), {m_forms});
  auto* noLargePart = standard(
      tr("Should be: no part of a bar is far larger than the others; if one is, the gap lies there."));
  m_whereBlock = block(tr("Where the gap lies"), {m_map, noLargePart, m_leftOver});
  m_blocks = {m_headline,
              m_causesBlock,
              m_formsBlock,
              m_stages,
              m_whereBlock,
              block(tr("What must agree"),
                    {m_closures, standard(tr("Should be: every bar ends inside the grey band of ± U.")),
                     m_closuresNote, m_withReference, m_withReferenceNote}),
              m_required,
              m_next,
              m_undetectable,
              m_known,
              createCandidates()};
  connect(m_remedies, &RemedyList::relationWanted, this, &GapPanel::relationWanted);
  connect(m_remedies, &RemedyList::placeActivated, this, &GapPanel::placeActivated);
  connect(m_remedies, &RemedyList::exclusionWanted, this, &GapPanel::exclusionWanted);
  connect(m_remedies, &RemedyList::rowsExclusionWanted, this, &GapPanel::rowsExclusionWanted);
  connect(m_remedies, &RemedyList::noiseWanted, this, &GapPanel::noiseWanted);
  connect(m_withReference, &QCheckBox::clicked, this, [this](bool wanted) {
    m_returnsToReference = true;
    emit referenceWanted(wanted);
  });
  showVerdict();
  layOutByFont(*this, [this] { arrange(); });
}

QPushButton* GapPanel::addAction(const QString& text, const QString& name, const QString& toolTip) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(toolTip);
  button->setAutoDefault(true);
  m_actions->addWidget(button);
  return button;
}

/// The table of causes, its actions, and the remedies for causes that are not effects of the model.
QWidget* GapPanel::createCauses() {
  m_causes->setTicks([this](const std::string& id) {
    return effectById(id) ? std::optional(!isInModel(id)) : std::nullopt;
  });
  m_addTicked = addAction(tr("Add the Ticked"), QStringLiteral("add ticked"),
                          tr("Estimates the ticked causes along with the arcs; undone by Ctrl+Z"));
  m_addLookAlikes = addAction(tr("With Look-alikes"), QStringLiteral("add look-alikes"),
                              tr("Estimates the ticked causes and their look-alikes, each within its "
                                 "plausible size: U then covers every one of them"));
  m_remove = addAction(tr("Take Out of the Model"), QStringLiteral("remove ticked"),
                       tr("Removes the ticked effects from the model"));
  m_actions->addStretch();
  connect(m_causes, &StatementView::ticksChanged, this, &GapPanel::showActions);
  connect(m_addTicked, &QPushButton::clicked, this, [this] { emit effectsWanted(ticked(false)); });
  connect(m_addLookAlikes, &QPushButton::clicked, this,
          [this] { emit effectsWanted(tickedWithLookAlikes()); });
  connect(m_remove, &QPushButton::clicked, this, [this] {
    for (const QString& id : ticked(true)) emit effectUnwanted(id);
  });
  auto* frame = new QWidget;
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_causes);
  layout->addLayout(m_actions);
  layout->addWidget(m_remedies);
  return frame;
}

QStringList GapPanel::ticked(bool isOfModel) const {
  QStringList ids = m_causes->ticked();
  ids.removeIf([&](const QString& id) { return isInModel(id.toStdString()) != isOfModel; });
  return ids;
}

QStringList GapPanel::tickedWithLookAlikes() const {
  QStringList ids = ticked(false);
  for (const Cause& cause : m_gap->diagnosis->causes) {
    if (!ids.contains(qText(cause.effect))) continue;
    for (const std::string& other : cause.indistinguishableFrom)
      if (effectById(other) && !isInModel(other) && !ids.contains(qText(other))) ids.append(qText(other));
  }
  return ids;
}

/// Shows an action if it applies to any row of the table, and enables the action if such a row is ticked.
void GapPanel::showActions() {
  const auto& causes = m_gap->diagnosis->causes;
  const auto canBeAdded = [](const Cause& cause) { return effectById(cause.effect) != nullptr; };
  const auto hasLookAlike = [&](const Cause& cause) {
    return canBeAdded(cause) && std::ranges::any_of(cause.indistinguishableFrom, [](const std::string& id) {
             return effectById(id) != nullptr;
           });
  };
  const QStringList wanted = ticked(false), inModel = ticked(true);
  m_addTicked->setVisible(std::ranges::any_of(causes, canBeAdded));
  m_addLookAlikes->setVisible(std::ranges::any_of(causes, hasLookAlike));
  m_remove->setVisible(m_gap->asModelled().kind == GapStage::Kind::InModel);
  m_addTicked->setEnabled(!wanted.isEmpty());
  m_addLookAlikes->setEnabled(tickedWithLookAlikes().size() > wanted.size());
  m_remove->setEnabled(!inModel.isEmpty());
}

QWidget* GapPanel::createCandidates() {
  const auto of = [this](auto text) {
    return [this, text](int row) { return candidate(row) ? text(*candidate(row)) : QString(); };
  };
  m_candidates = new DataTable({
      {tr("Effect"), tr("What may cause the gap"), tr("Vertical angle relation"),
       of([](const Candidate& c) { return causeTitle(c.effect); }), Qt::AlignLeft},
      {tr("ln B"),
       tr("Natural logarithm of the Bayes factor for the effect: above 0 the effect explains the readings "
          "better than no effect, above 5 far better, below 0 worse"),
       QStringLiteral("−8888.8"), of([](const Candidate& c) { return numberText(c.logBayesFactor, 1); })},
      {tr("Visible σ"), tr("How far the effect shows in the readings, in σ of one reading"),
       QStringLiteral("888.8"), of([](const Candidate& c) {
         return c.visibleSigma > 0 ? numberText(c.visibleSigma, 1) : notStated();
       })},
      {tr("Role"), tr("Role of the effect in the diagnosis"), tr("look-alike"),
       of([this](const Candidate& c) {
         for (const Cause& cause : m_gap->diagnosis->causes) {
           if (cause.effect == c.effect) return tr("cause");
           const auto& alike = cause.indistinguishableFrom;
           if (std::find(alike.begin(), alike.end(), c.effect) != alike.end()) return tr("look-alike");
         }
         return isInModel(c.effect) ? tr("in the model") : QString();
       }),
       Qt::AlignLeft},
  });
  m_candidates->setAccessibleName(tr("Candidates"));
  m_candidates->setSelectionMode(QAbstractItemView::SingleSelection);
  m_candidates->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_candidates->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_candidates->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_candidates->setPlaceholder(tr("No candidates."));
  m_add = new QPushButton;
  m_add->setObjectName(QStringLiteral("add candidate"));
  connect(m_candidates->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &GapPanel::showCandidate);
  connect(m_add, &QPushButton::clicked, this, &GapPanel::addCandidate);
  return block(tr("Candidates, each by itself"), {m_candidates, m_add});
}

/// Lays out two columns below headline, causes and forms if the width allows, else one; hidden blocks last.
void GapPanel::arrange() {
  const int columns = viewport()->width() >= byFont(twoColumnsFrom) ? 2 : 1;
  m_grid->setColumnStretch(0, columns == 2 ? 4 : 1);
  m_grid->setColumnStretch(1, columns == 2 ? 5 : 0);
  constexpr int wide = 3;
  for (int row = 0; row < wide; ++row) m_grid->addWidget(m_blocks[row], row, 0, 1, columns);
  QList<QWidget*> parts = m_blocks.mid(wide);
  std::stable_partition(parts.begin(), parts.end(), [](const QWidget* part) { return !part->isHidden(); });
  for (int i = 0; i < parts.size(); ++i)
    m_grid->addWidget(parts[i], wide + i / columns, i % columns, Qt::AlignTop);
}

void GapPanel::setGap(const SharedGap& gap) {
  m_gap = gap;
  showVerdict();
  if (!gap->diagnosis) return;
  m_map->setShares(gap->diagnosis->where);
  m_leftOver->setGap(*gap);
  const auto rows = static_cast<int>(gap->diagnosis->candidates.size());
  m_candidates->setRows(rows);
  m_candidates->setFixedHeight(m_candidates->horizontalHeader()->sizeHint().height() +
                               std::max(1, rows) * m_candidates->verticalHeader()->defaultSectionSize() +
                               2 * m_candidates->frameWidth());
  if (!m_candidates->currentIndex().isValid()) m_candidates->selectDataRows({0});
  showCandidate();
  showClosures();
  showReference();
}

void GapPanel::setStale() {
  widget()->setEnabled(false);
}

void GapPanel::clear() {
  m_gap.reset();
  showVerdict();
}

void GapPanel::showVerdict() {
  widget()->setEnabled(true);
  const Gap* gap = m_gap.get();
  const bool says = gap && gap->diagnosis;
  if (gap)
    m_headline->setGap(*gap);
  else
    m_headline->setText(tr("No diagnosis"),
                        tr("The readings are compared with the model as soon as there are any."));
  for (int i = 1; i < m_blocks.size(); ++i) m_blocks[i]->setVisible(says);
  if (says) {
    const Statement causes = gapCauses(*gap);
    m_causes->setStatement(causes);
    m_remedies->setGap(*gap);
    m_forms->setGap(*gap);
    m_stages->setStatement(gapStages(*gap));
    m_required->setStatement(gapRequired(*gap));
    m_next->setStatement(gapAdvice(*gap));
    m_undetectable->setStatement(gapUndetectable(*gap));
    m_known->setStatement(gapKnown(*gap));
    showActions();
    m_causesBlock->setVisible(!causes.rows.empty());
    m_formsBlock->setVisible(!gap->diagnosis->forms.empty());
    m_whereBlock->setVisible(gap->isOpen());
  }
  arrange();
}

void GapPanel::showClosures() {
  const Statement closures = gapClosures(*m_gap);
  m_closures->setGap(*m_gap);
  m_closures->setVisible(!m_closures->isEmpty());
  m_closuresNote->setText(qText(closures.sentences.front()));
}

/// Shows the switch if the measurement states the uncertainty of the reference.
void GapPanel::showReference() {
  m_withReference->setVisible(m_gap->evaluation->examined.measurement->sigmaReference.has_value());
  m_withReferenceNote->setVisible(!m_withReference->isHidden());
  m_withReference->setChecked(m_gap->isWithReference);
  if (std::exchange(m_returnsToReference, false) && hasFocus()) m_withReference->setFocus();
}

const Candidate* GapPanel::candidate(int row) const {
  if (!m_gap || !m_gap->diagnosis || row < 0) return nullptr;
  const auto& list = m_gap->diagnosis->candidates;
  return static_cast<std::size_t>(row) < list.size() ? &list[static_cast<std::size_t>(row)] : nullptr;
}

bool GapPanel::isInModel(const std::string& id) const {
  const auto& effects = m_gap->evaluation->session.model.effects;
  return std::find(effects.begin(), effects.end(), id) != effects.end();
}

/// Enables the button for the candidate in the current row, and names the candidate on it.
void GapPanel::showCandidate() {
  const Candidate* current = candidate(m_candidates->currentIndex().row());
  const bool isEffect = current && effectById(current->effect);
  m_add->setEnabled(isEffect && !isInModel(current->effect));
  m_add->setText(!current   ? tr("A&dd to the model")
                 : isEffect ? tr("A&dd %1 to the model").arg(causeName(current->effect))
                            : tr("%1: nothing to add to the model").arg(causeTitle(current->effect)));
}

void GapPanel::addCandidate() {
  if (const Candidate* current = candidate(m_candidates->currentIndex().row()))
    emit effectsWanted({qText(current->effect)});
}

void GapPanel::resizeEvent(QResizeEvent* event) {
  ScrollPage::resizeEvent(event);
  arrange();
}

void GapPanel::showEvent(QShowEvent* event) {
  ScrollPage::showEvent(event);
  emit watched(true);
}

void GapPanel::hideEvent(QHideEvent* event) {
  ScrollPage::hideEvent(event);
  emit watched(false);
}

}  // namespace alidade::ui

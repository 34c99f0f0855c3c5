#include "ui/panels/gap/gap_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/wording/closures.h"
#include "core/wording/known_checks.h"
#include "core/wording/measure.h"
#include "core/wording/verdict.h"
#include "ui/charts/gap/closure_bars.h"
#include "ui/charts/gap/gap_map.h"
#include "ui/charts/gap/gap_waterfall.h"
#include "ui/charts/gap/leftover_strips.h"
#include "ui/panels/gap/cause_list.h"
#include "ui/panels/gap/form_list.h"
#include "ui/panels/gap/gap_headline.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/settings/window_font.h"
#include "ui/text/cause_text.h"
#include "ui/text/closure_text.h"
#include "ui/text/effect_text.h"
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

/// A sentence that describes a good picture.
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
      m_causes(new CauseList),
      m_forms(new FormList),
      m_waterfall(new GapWaterfall),
      m_result(new FigureGrid),
      m_shrinkage(wrappedLabel()),
      m_map(new GapMap),
      m_leftOver(new LeftoverStrips),
      m_candidates(nullptr),
      m_add(nullptr),
      m_closures(new ClosureBars),
      m_closuresNote(wrappedLabel()),
      m_withReference(new QCheckBox(tr("Weigh the causes with the reference"))),
      m_withReferenceNote(wrappedLabel()),
      m_required(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_requiredNote(wrappedLabel()),
      m_next(wrappedLabel()),
      m_undetectable(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_undetectableNote(wrappedLabel()) {
  setFocusPolicy(Qt::StrongFocus);
  column()->addLayout(m_grid);
  column()->addStretch();
  m_grid->setHorizontalSpacing(22);
  m_grid->setVerticalSpacing(6);
  m_shrinkage->setForegroundRole(QPalette::PlaceholderText);
  m_undetectableNote->setForegroundRole(QPalette::PlaceholderText);
  m_requiredNote->setForegroundRole(QPalette::PlaceholderText);
  m_withReferenceNote->setForegroundRole(QPalette::PlaceholderText);
  m_withReferenceNote->setText(tr("Δd itself never rests on it."));
  m_withReference->setObjectName(QStringLiteral("with reference"));
  m_withReference->setToolTip(
      tr("How far Δd is from the reference then helps to tell the causes apart.\n"
         "Δd with the causes rests on the readings alone, and so does the report."));
  connect(m_forms, &FormList::keepWanted, this,
          [this](std::size_t form) { emit formWanted(m_gap->diagnosis->forms[form]); });
  m_formsBlock = block(tr("Form"), {m_forms});
  m_whereBlock =
      block(tr("Where it lies"),
            {m_map, standard(tr("Good: no part stands out; one that does is where to look.")), m_leftOver});
  m_requiredBlock = block(tr("What it would take to explain Δd − reference"), {m_required, m_requiredNote});
  m_blocks = {m_headline,
              m_formsBlock,
              block(tr("Causes"), {m_causes}),
              block(tr("Before and after"),
                    {m_waterfall, standard(tr("Good: the last bar ends at the broken line of the noise.")),
                     m_result, m_shrinkage}),
              m_whereBlock,
              block(tr("What must agree"),
                    {m_closures, standard(tr("Good: every bar ends inside the grey band of ± U.")),
                     m_closuresNote, m_withReference, m_withReferenceNote}),
              m_requiredBlock,
              block(tr("What to measure next"), {m_next}),
              block(tr("What would go unseen"), {m_undetectable, m_undetectableNote}),
              createCandidates()};
  connect(m_causes, &CauseList::effectsWanted, this, &GapPanel::effectsWanted);
  connect(m_causes, &CauseList::effectUnwanted, this, &GapPanel::effectUnwanted);
  connect(m_causes, &CauseList::relationWanted, this, &GapPanel::relationWanted);
  connect(m_causes, &CauseList::placeActivated, this, &GapPanel::placeActivated);
  connect(m_causes, &CauseList::exclusionWanted, this, &GapPanel::exclusionWanted);
  connect(m_causes, &CauseList::rowsExclusionWanted, this, &GapPanel::rowsExclusionWanted);
  connect(m_causes, &CauseList::noiseWanted, this, &GapPanel::noiseWanted);
  connect(m_withReference, &QCheckBox::clicked, this, [this](bool wanted) {
    m_returnsToReference = true;
    emit referenceWanted(wanted);
  });
  showVerdict();
  layOutByFont(*this, [this] { arrange(); });
}

QWidget* GapPanel::createCandidates() {
  const auto of = [this](auto text) {
    return [this, text](int row) { return candidate(row) ? text(*candidate(row)) : QString(); };
  };
  m_candidates = new DataTable({
      {tr("Effect"), tr("What may cause the gap"), tr("Vertical angle relation"),
       of([](const Candidate& c) { return causeTitle(c.effect); }), Qt::AlignLeft},
      {tr("ln B"),
       tr("Natural logarithm of the Bayes factor against no effect at all: above 0 it explains the readings "
          "better, above 5 far better, below 0 worse"),
       QStringLiteral("−8888.8"), of([](const Candidate& c) { return numberText(c.logBayesFactor, 1); })},
      {tr("Visible σ"), tr("How much of the readings it explains, in σ of one reading"),
       QStringLiteral("888.8"), of([](const Candidate& c) {
         return c.visibleSigma > 0 ? numberText(c.visibleSigma, 1) : notStated();
       })},
      {tr("Role"), tr("What the diagnosis makes of it"), tr("look-alike"), of([this](const Candidate& c) {
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

/// Two columns below headline and forms if the width allows, else one; hidden blocks come last.
void GapPanel::arrange() {
  const int columns = viewport()->width() >= byFont(twoColumnsFrom) ? 2 : 1;
  m_grid->setColumnStretch(0, columns == 2 ? 4 : 1);
  m_grid->setColumnStretch(1, columns == 2 ? 5 : 0);
  constexpr int wide = 2;
  for (int row = 0; row < wide; ++row) m_grid->addWidget(m_blocks[row], row, 0, 1, columns);
  QList<QWidget*> parts = m_blocks.mid(wide);
  std::stable_partition(parts.begin(), parts.end(), [](const QWidget* part) { return !part->isHidden(); });
  for (int i = 0; i < parts.size(); ++i) m_grid->addWidget(parts[i], wide + i / columns, i % columns);
}

void GapPanel::setGap(const SharedGap& gap) {
  m_gap = gap;
  showVerdict();
  if (!gap->diagnosis) return;
  m_causes->setGap(*gap);
  m_forms->setGap(*gap);
  m_waterfall->setGap(*gap);
  m_map->setShares(gap->diagnosis->where);
  m_leftOver->setGap(*gap);
  showEffectOnResult();
  showShrinkage();
  const auto rows = static_cast<int>(gap->diagnosis->candidates.size());
  m_candidates->setRows(rows);
  m_candidates->setFixedHeight(m_candidates->horizontalHeader()->sizeHint().height() +
                               std::max(1, rows) * m_candidates->verticalHeader()->defaultSectionSize() +
                               2 * m_candidates->frameWidth());
  if (!m_candidates->currentIndex().isValid()) m_candidates->selectDataRows({0});
  showCandidate();
  showClosures();
  showReference();
  showRequired();
  showNext();
  showUndetectable();
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
    const bool hasCauses = !gap->diagnosis->causes.empty() || CauseList::tellsShape(*gap->diagnosis) ||
                           std::ranges::any_of(gap->stages, [](const GapStage& stage) {
                             return stage.kind == GapStage::Kind::InModel;
                           });
    m_blocks[2]->setVisible(hasCauses);
    m_formsBlock->setVisible(!gap->diagnosis->forms.empty());
    m_whereBlock->setVisible(gap->isOpen());
    m_requiredBlock->setVisible(!gap->diagnosis->whatItWouldTake.empty());
  }
  arrange();
}

/// Δd without the model's effects, fit only, with the causes, and measured.
void GapPanel::showEffectOnResult() {
  const Diagnosis& diagnosis = *m_gap->diagnosis;
  const GapStage &bare = m_gap->stages.front(), &modelled = m_gap->asModelled();
  QVector<FigureGrid::Row> rows;
  const auto add = [&](const QString& caption, const std::optional<IntersectionEstimate>& estimate,
                       const QString& toolTip) {
    rows.append({caption, {estimateText(estimate)}, toolTip});
  };
  if (&bare != &modelled) add(tr("before"), bare.intersection, tr("Without the effects of the model"));
  add(tr("as modelled"), modelled.intersection, {});
  if (!diagnosis.forms.empty())
    add(tr("with the form"), diagnosis.afterwards,
        tr("Averaged over what else may be the case, each as likely as it is"));
  else if (diagnosis.shape)
    add(tr("with the pattern"), diagnosis.afterwards, tr("U holds what it may move Δd by"));
  else if (!diagnosis.steps.empty())
    add(tr("with the causes"), diagnosis.afterwards,
        tr("Averaged over what else may be the case, each as likely as it is"));
  const MeasuredIntersection* measured = m_gap->measured();
  add(tr("measured"), measured ? std::optional(measured->estimate) : std::nullopt,
      tr("Every effect of the catalogue takes part, as large as these readings and what is plausible leave "
         "it"));
  m_result->setRows({tr("Δd ± U  mm")}, rows);
}

void GapPanel::showShrinkage() {
  const Diagnosis& diagnosis = *m_gap->diagnosis;
  QStringList says;
  if (!diagnosis.steps.empty() && diagnosis.shrink.inSample > 0.005)
    says.append(
        std::isfinite(diagnosis.shrink.heldOut)
            ? tr("The residuals shrink by %1 %, by %2 % on readings held out of the fit.")
                  .arg(numberText(100 * diagnosis.shrink.inSample, 0),
                       numberText(100 * diagnosis.shrink.heldOut, 0))
            : tr("The residuals shrink by %1 %; there are too few readings to hold any out of the fit.")
                  .arg(numberText(100 * diagnosis.shrink.inSample, 0)));
  for (const KnownCheck& check : diagnosis.known) says.append(qText(textOf(check, causeNameInCore)) + u'.');
  if (!diagnosis.forms.empty())
    says.append(tr("Δd with the form is averaged over what looks like it; what causes it is not known."));
  else if (diagnosis.shape)
    says.append(tr("U holds what the pattern may move Δd by; what causes it is not known."));
  else if (beyondTheFit(diagnosis) != Beyond::Nothing)
    says.append(
        tr("Δd with the causes is averaged over all that may be the case, each as likely as it is; the "
           "first alone would state a U that is too small."));
  m_shrinkage->setText(says.join(u' '));
  m_shrinkage->setVisible(!says.isEmpty());
}

void GapPanel::showNext() {
  const Diagnosis& diagnosis = *m_gap->diagnosis;
  QStringList lines;
  for (const Advice& advice : diagnosis.advice) {
    const QString figure = numberText(advice.bySigma, 1);
    const QString what = causeNames(advice.separates, tr(" and ")).toHtmlEscaped();
    QString line = QStringLiteral("• <b>%1</b>: ").arg(qText(howTo(advice.measures)).toHtmlEscaped());
    line += advice.ofUndetectable ? tr("would show %1 by %2 σ or more").arg(what, figure)
                                  : tr("separates every two of %1 by %2 σ or more").arg(what, figure);
    if (advice.oneLeft > 0)
      line += tr("; one answer is left with a probability of %1")
                  .arg(qText(shortProbabilityText(advice.oneLeft)));
    lines.append(line);
  }
  m_next->setTextFormat(Qt::RichText);
  m_next->setText(lines.isEmpty() ? tr("No further reading of the usual kinds would tell more.")
                                  : lines.join(QStringLiteral("<br>")));
}

void GapPanel::showClosures() {
  const Diagnosis& diagnosis = *m_gap->diagnosis;
  m_closures->setGap(*m_gap);
  m_closures->setVisible(!m_closures->isEmpty());
  const QString open = qText(misclosureSentence(diagnosis));
  const bool failed =
      std::ranges::any_of(diagnosis.closures, [](const ClosureStep& step) { return fails(step.before); });
  m_closuresNote->setText(m_closures->isEmpty() ? tr("Both positions are needed to compare them.")
                          : !open.isEmpty()     ? open
                          : failed              ? tr("With the causes in the model they agree.")
                                                : tr("One rigid arc turned about a level axis: they agree."));
}

/// The switch is shown if the measurement states the uncertainty of the reference.
void GapPanel::showReference() {
  m_withReference->setVisible(m_gap->evaluation->examined.measurement->sigmaReference.has_value());
  m_withReferenceNote->setVisible(!m_withReference->isHidden());
  m_withReference->setChecked(m_gap->isWithReference);
  if (std::exchange(m_returnsToReference, false) && hasFocus()) m_withReference->setFocus();
}

void GapPanel::showRequired() {
  QVector<FigureGrid::Row> rows;
  for (const Required& required : m_gap->diagnosis->whatItWouldTake)
    rows.append(
        {causeTitle(required.effect),
         {requiredSizeText(required), plausibleSizesText(required), numberText(required.visibleSigma, 1)}});
  m_required->setRows({tr("size"), tr("plausible\nsizes"), tr("leaves\nσ")}, rows);
  m_requiredNote->setText(
      tr("Each by itself, of the effects that these readings do not exclude at that size; "
         "the most plausible first."));
}

/// The change of Δd by a plausible size of each undetectable effect.
void GapPanel::showUndetectable() {
  QVector<FigureGrid::Row> rows;
  for (const UndetectableEffect& effect : m_gap->noticeablyUndetectable())
    rows.append({causeTitle(effect.effect),
                 {QStringLiteral("± ") + numberText(effect.influence, decimalsFor(effect.influence)),
                  numberText(effect.visibleSigma, 1)}});
  m_undetectable->setVisible(!rows.isEmpty());
  m_undetectable->setRows({tr("moves Δd  mm"), tr("leaves  σ")}, rows);
  m_undetectableNote->setText(
      rows.isEmpty() ? tr("No effect of plausible size could move Δd noticeably without leaving a trace.")
                     : tr("At their plausible size, without a clear trace in these readings."));
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

/// The button follows the current row.
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

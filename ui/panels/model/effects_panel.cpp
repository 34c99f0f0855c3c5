#include "ui/panels/model/effects_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/phrase.h"
#include "core/effects/catalogue.h"
#include "core/session/own_effects.h"
#include "ui/commands/change_session.h"
#include "ui/document/session_document.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int idRole = Qt::UserRole;
constexpr int longestId = 24;  // characters

std::string idOf(const QTreeWidgetItem& item) {
  return item.data(0, idRole).toString().toStdString();
}

QString aboutText(const Effect& effect) {
  QStringList sizes;
  for (const EffectParameter& parameter : effect.parameters) {
    if (parameter.unit == "-") continue;  // a yes-or-no effect without a size
    const QString size = plausibleText(parameter);
    if (!sizes.contains(size)) sizes.append(size);
  }
  const QString what = capitalised(qText(Phrase::of(effect.description)));
  const QString remedy = qText(Phrase::of(effect.remedy));
  if (sizes.isEmpty()) return EffectsPanel::tr("%1. Remedy: %2.").arg(what, remedy);
  return EffectsPanel::tr("%1. Plausible size (1σ) %2. Remedy: %3.").arg(what, listText(sizes), remedy);
}

/// Sets what a screen reader says in the cell of the size.
void speakSize(QTreeWidgetItem& item) {
  const QString size = item.text(1);
  item.setData(1, Qt::AccessibleTextRole, size.isEmpty() ? EffectsPanel::tr("no size in this row") : size);
}

QString sizeText(const EffectEstimate& estimate) {
  return withStandardUncertainty(estimate.value, estimate.sigma, effectUnitText(estimate));
}

}  // namespace

EffectsPanel::EffectsPanel(SessionDocument& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_list(new QTreeWidget), m_about(new QLabel) {
  m_list->setAccessibleName(tr("Effects estimated with the arcs"));
  m_list->setHeaderLabels({tr("Also estimate"), tr("Size")});
  m_list->headerItem()->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  m_list->header()->setStretchLastSection(false);
  m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  m_list->setRootIsDecorated(false);
  m_list->setIndentation(14);
  m_list->setAlternatingRowColors(true);
  for (const Effect& effect : effectCatalogue())
    addItem(std::string(effect.id), capitalised(effectName(std::string(effect.id))))
        ->setToolTip(0, aboutText(effect));
  m_about->setWordWrap(true);
  QSizePolicy policy = m_about->sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Ignored);  // prevents a long word from widening the page
  m_about->setSizePolicy(policy);
  layOutByFont(*this, [this] { m_about->setMinimumHeight(4 * fontMetrics().lineSpacing()); });
  m_about->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* known = new QPushButton(tr("Known Size…"));
  known->setToolTip(tr("Type the size of the effect from a certificate or a check"));
  connect(known, &QPushButton::clicked, this, &EffectsPanel::askForKnown);
  auto* own = new QPushButton(tr("Effect of Your Own…"));
  own->setToolTip(tr("Defines an effect by its formula, or changes the selected one"));
  connect(own, &QPushButton::clicked, this, [this] {
    const QTreeWidgetItem* item = m_list->currentItem();
    emit ownWanted(item && idOf(*item).starts_with(ownPrefix) ? idOf(*item) : std::string());
  });
  setFocusProxy(m_list);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_list, 1);
  layout->addWidget(m_about);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(known);
  buttons->addWidget(own);
  buttons->addStretch();
  layout->addLayout(buttons);
  connect(m_list, &QTreeWidget::itemChanged, this, &EffectsPanel::handIn);
  connect(m_list, &QTreeWidget::currentItemChanged, this, &EffectsPanel::explain);
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    const bool mine = change.place.field == "model.effects" || change.place.field == "own_effects";
    if (mine || change.kind == SessionChange::Kind::Everything) refreshTicks();
  });
  refreshTicks();
  explain(nullptr);
}

QTreeWidgetItem* EffectsPanel::addItem(const std::string& id, const QString& name) {
  auto* item = new QTreeWidgetItem(m_list, {name});
  item->setData(0, idRole, qText(id));
  item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(0, Qt::Unchecked);
  speakSize(*item);
  return item;
}

/// Adds the user's own effects, then the model's effects of unknown id, which vanish when unticked.
void EffectsPanel::addUnknown() {
  const auto known = static_cast<int>(effectCatalogue().size());
  while (m_list->topLevelItemCount() > known) delete m_list->takeTopLevelItem(known);
  const auto& own = m_document.session().ownEffects;
  for (const OwnEffect& effect : own)
    addItem(ownId(effect), capitalised(effectName(ownId(effect))))->setToolTip(0, qText(effect.description));
  for (const std::string& id : m_document.session().model.effects) {
    if (effectById(id) || std::ranges::find(own, id, ownId) != own.end()) continue;
    QTreeWidgetItem* item = addItem(id, shortLine(id, longestId));
    item->setIcon(0, themeIcon(QStringLiteral("problem")));
    item->setToolTip(0, tr("“%1” is no effect of the catalogue; it is kept, but not estimated.")
                            .arg(shortLine(id, longestId)));
  }
}

void EffectsPanel::refreshTicks() {
  const QSignalBlocker quiet(m_list);
  addUnknown();
  const std::vector<std::string>& effects = m_document.session().model.effects;
  for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = m_list->topLevelItem(i);
    const bool isEstimated = std::find(effects.begin(), effects.end(), idOf(*item)) != effects.end();
    item->setCheckState(0, isEstimated ? Qt::Checked : Qt::Unchecked);
  }
}

void EffectsPanel::handIn(QTreeWidgetItem* item) {
  if (item->parent()) return;
  const std::string id = idOf(*item);
  const bool isEstimated = item->checkState(0) == Qt::Checked;
  // Queued, since the edit may delete the item whose signal the list is still emitting.
  QMetaObject::invokeMethod(
      this, [this, id, isEstimated] { setEffect(m_document, id, isEstimated); }, Qt::QueuedConnection);
}

/// Shows a single size in the row of the effect, several sizes in rows below it.
void EffectsPanel::setEvaluation(const Evaluation& evaluation) {
  const QSignalBlocker quiet(m_list);
  const auto& estimates = evaluation.fit.effects;
  const auto isOne = [&](const std::string& id) {
    return std::ranges::count(estimates, id, &EffectEstimate::effect) == 1;
  };
  for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = m_list->topLevelItem(i);
    qDeleteAll(item->takeChildren());
    item->setText(1, {});
    const std::string id = idOf(*item);
    for (const EffectEstimate& estimate : estimates) {
      if (estimate.effect != id) continue;
      if (isOne(id)) {
        item->setText(1, sizeText(estimate));
      } else {
        auto* child = new QTreeWidgetItem(item, {qText(parameterName(estimate.name)), sizeText(estimate)});
        child->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
      }
    }
    item->setExpanded(item->childCount() > 0);
    speakSize(*item);
  }
}

void EffectsPanel::explain(const QTreeWidgetItem* item) {
  const QTreeWidgetItem* top = item && item->parent() ? item->parent() : item;
  m_about->setText(top ? top->toolTip(0)
                       : tr("A ticked effect is estimated together with the arcs. Its share of U is in the "
                            "budget under “model effects”."));
}

void EffectsPanel::askForKnown() {
  const QTreeWidgetItem* item = m_list->currentItem();
  const QTreeWidgetItem* top = item && item->parent() ? item->parent() : item;
  emit knownWanted(top ? idOf(*top) : std::string());
}

}  // namespace alidade::ui

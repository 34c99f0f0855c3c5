#include "ui/series/history_choices.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <algorithm>

#include "core/series/history/history_sentences.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

std::optional<std::size_t> chosenIn(const QComboBox& choice) {
  const int index = choice.currentIndex();
  return index >= 0 ? std::optional(static_cast<std::size_t>(index)) : std::nullopt;
}

/// Selects `kept`, or the first choice if `kept` no longer exists.
void choose(QComboBox& choice, int kept) {
  choice.setCurrentIndex(std::max(kept, choice.count() > 0 ? 0 : -1));
}

}  // namespace

HistoryChoices::HistoryChoices(const Words& words, QWidget* parent)
    : QWidget(parent), m_owners(new QComboBox), m_quantities(new QComboBox), m_baseline(new QSpinBox) {
  m_owners->setAccessibleName(words.owner);
  m_quantities->setAccessibleName(tr("Quantity"));
  m_baseline->setAccessibleName(words.baseline);
  m_baseline->setSpecialValueText(words.all);
  m_baseline->setToolTip(words.tip);
  m_baseline->setKeyboardTracking(false);
  for (QComboBox* choice : {m_owners, m_quantities}) choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [layout](const QString& text, QWidget* choice) {
    auto* label = new QLabel(text);
    label->setBuddy(choice);
    layout->addWidget(label);
    layout->addWidget(choice);
    return label;
  };
  m_ownersLabel = add(words.ownerLabel, m_owners);
  add(tr("&Quantity"), m_quantities);
  add(tr("&Baseline"), m_baseline);
  layout->addStretch();
  connect(m_owners, &QComboBox::activated, this, &HistoryChoices::ownerChosen);
  connect(m_quantities, &QComboBox::activated, this, &HistoryChoices::quantityChosen);
  connect(m_baseline, &QSpinBox::valueChanged, this, &HistoryChoices::baselineChosen);
}

void HistoryChoices::setOwners(const QStringList& names) {
  const QString kept = m_owners->currentText();
  m_owners->clear();
  m_owners->addItems(names);
  choose(*m_owners, m_owners->findText(kept));
  m_ownersLabel->setVisible(names.size() > 1);
  m_owners->setVisible(names.size() > 1);
}

void HistoryChoices::setQuantities(const std::vector<QuantityHistory>& quantities) {
  const QVariant kept = m_quantities->currentData();
  m_quantities->clear();
  for (const QuantityHistory& one : quantities)
    m_quantities->addItem(qText(quantityName(one.id)), qText(one.id));
  m_quantities->setEnabled(!quantities.empty());
  choose(*m_quantities, kept.isValid() ? m_quantities->findData(kept) : -1);
}

void HistoryChoices::setMostInBaseline(std::size_t most) {
  m_baseline->setMaximum(std::max(m_baseline->value(), static_cast<int>(most)));
  m_baseline->setEnabled(most > 1);
}

void HistoryChoices::setBaseline(int values) {
  m_baseline->setMaximum(std::max(m_baseline->maximum(), values));
  m_baseline->setValue(values);
}

std::optional<std::size_t> HistoryChoices::owner() const {
  return chosenIn(*m_owners);
}

std::optional<std::size_t> HistoryChoices::quantity() const {
  return chosenIn(*m_quantities);
}

int HistoryChoices::baseline() const {
  return m_baseline->value();
}

}  // namespace alidade::ui

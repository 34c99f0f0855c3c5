#include "ui/series/history_panel.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "core/series/history/history_sentences.h"
#include "core/series/history/history_statement.h"
#include "core/wording/findings.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/frames.h"
#include "ui/series/history_chart.h"
#include "ui/series/history_choices.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

HistoryPanel::HistoryPanel(QWidget* parent)
    : QWidget(parent),
      m_choices(new HistoryChoices({.owner = tr("Device"),
                                    .ownerLabel = tr("&Device"),
                                    .baseline = tr("Sessions in the baseline"),
                                    .all = tr("all sessions"),
                                    .tip = tr("The first sessions define centre line and limits for the "
                                              "later ones: choose those measured before any change")})),
      m_chart(new HistoryChart) {
  auto* picture = new QWidget;
  auto* pictureLayout = new QVBoxLayout(picture);
  pictureLayout->setContentsMargins(0, 0, 0, 0);
  pictureLayout->addWidget(m_choices);
  pictureLayout->addWidget(m_chart, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  QSplitter* parts = split(Qt::Horizontal, "history parts", {picture, scrolled(createText())}, {620, 360});
  layout->addWidget(parts);
  connect(m_choices, &HistoryChoices::ownerChosen, this, [this] {
    showQuantities();
    emit deviceChosen();
  });
  connect(m_choices, &HistoryChoices::baselineChosen, this, [this] {
    takeBaseline();
    showHistory();
    emit baselineChosen();
  });
  connect(m_choices, &HistoryChoices::quantityChosen, this, &HistoryPanel::showHistory);
  connect(m_chart, &PlotWidget::sightingActivated, this,
          [this](std::size_t, std::size_t value) { activate(value, true); });
  connect(m_chart, &PlotWidget::sightingStepped, this,
          [this](std::size_t, std::size_t value) { activate(value, false); });
  setSeries(nullptr);
}

QWidget* HistoryPanel::createText() {
  m_says = wrappedLabel();
  m_says->setObjectName(QStringLiteral("history says"));
  m_congruence = wrappedLabel();
  m_congruence->setObjectName(QStringLiteral("congruence"));
  auto* text = new QWidget;
  auto* layout = new QVBoxLayout(text);
  layout->setContentsMargins(8, 0, 4, 0);
  layout->addWidget(panelHeading(tr("What the history says")));
  layout->addWidget(m_says);
  layout->addSpacing(8);
  layout->addWidget(panelHeading(tr("Two sessions compared")));
  layout->addWidget(m_congruence);
  layout->addStretch();
  return text;
}

const DeviceHistory* HistoryPanel::device() const {
  const auto chosen = m_choices->owner();
  return chosen ? &m_deviceHistories[*chosen] : nullptr;
}

const QuantityHistory* HistoryPanel::quantity() const {
  const DeviceHistory* shown = device();
  const auto chosen = m_choices->quantity();
  return shown && chosen ? &shown->quantities[*chosen] : nullptr;
}

void HistoryPanel::setSeries(const SharedSeries& series) {
  m_deviceHistories = series ? series->devices : std::vector<DeviceHistory>();
  std::size_t most = 0;
  for (const DeviceHistory& one : m_deviceHistories) most = std::max(most, one.epochs.size());
  m_choices->setMostInBaseline(most);
  takeBaseline();
  QStringList names;
  for (const DeviceHistory& one : m_deviceHistories) names.append(menuText(qText(deviceName(one))));
  m_choices->setOwners(names);
  showQuantities();
}

void HistoryPanel::setBaseline(int sessions) {
  m_choices->setBaseline(sessions);
}

int HistoryPanel::baseline() const {
  return m_choices->baseline();
}

void HistoryPanel::takeBaseline() {
  for (DeviceHistory& one : m_deviceHistories)
    alidade::setBaseline(one, static_cast<std::size_t>(m_choices->baseline()));
}

void HistoryPanel::showQuantities() {
  const DeviceHistory* shown = device();
  m_choices->setQuantities(shown ? shown->quantities : std::vector<QuantityHistory>());
  showHistory();
}

void HistoryPanel::showHistory() {
  const QuantityHistory* shown = quantity();
  if (!shown) {
    m_chart->setHistory({}, {}, {});
    m_says->setText(tr("Nothing yet: the history of a device begins with its second session."));
  } else {
    m_chart->setHistory(shown->history, qText(quantityName(shown->id)), shown->unit);
    m_says->setText(paragraphs(quantitySentences(*device(), *shown)));
  }
  compare(m_compared);
}

void HistoryPanel::compare(const std::vector<std::string>& files) {
  m_compared = files;
  const DeviceHistory* shown = device();
  std::vector<std::size_t> epochs;
  if (shown)
    for (std::size_t i = 0; i < shown->epochs.size(); ++i)
      if (std::ranges::find(files, shown->epochs[i].file) != files.end()) epochs.push_back(i);
  if (files.size() != 2 || epochs.size() != 2) {
    m_congruence->setText(files.size() == 2 && shown
                              ? tr("At least one of these two sessions does not belong to the device shown.")
                              : tr("Select two sessions in the table (with Ctrl) to see whether the device "
                                   "has changed between them."));
    return;
  }
  m_congruence->setText(
      paragraphs(congruenceSentences(shown->epochs, congruenceOf(shown->epochs, epochs[0], epochs[1]))));
}

/// Highlights nothing if a session lacks the quantity, since sessions and values then have different indices.
void HistoryPanel::highlight(const std::string& file) {
  m_chart->clearHighlight();
  const DeviceHistory* shown = device();
  const QuantityHistory* drawn = quantity();
  if (!shown || !drawn || drawn->history.values.size() != shown->epochs.size()) return;
  const auto found = std::ranges::find(shown->epochs, file, &Epoch::file);
  if (found != shown->epochs.end())
    m_chart->setHighlighted(0, static_cast<std::size_t>(found - shown->epochs.begin()));
}

void HistoryPanel::activate(std::size_t value, bool wanted) {
  const DeviceHistory* shown = device();
  const QuantityHistory* drawn = quantity();
  if (!shown || !drawn || value >= drawn->history.values.size()) return;
  const auto found = std::ranges::find(shown->epochs, drawn->history.values[value].file, &Epoch::file);
  if (found == shown->epochs.end()) return;
  wanted ? emit sessionWanted(found->file) : emit sessionStepped(found->file);
}

}  // namespace alidade::ui

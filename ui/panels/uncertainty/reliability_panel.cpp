#include "ui/panels/uncertainty/reliability_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/panels/parts/data_table.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

QString circleText(ReadingKind kind) {
  switch (kind) {
    case ReadingKind::Horizontal:
      return ReliabilityPanel::tr("horizontal");
    case ReadingKind::Vertical:
      return ReliabilityPanel::tr("vertical");
    case ReadingKind::Slider:
      break;
  }
  return ReliabilityPanel::tr("slider");
}

}  // namespace

ReliabilityPanel::ReliabilityPanel(QWidget* parent)
    : QWidget(parent),
      m_evaluation(std::make_shared<const Evaluation>()),
      m_summary(new QLabel),
      m_table(createTable()) {
  m_summary->setWordWrap(true);
  m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_table->setAccessibleName(tr("Reliability of every reading"));
  m_table->setPlaceholder(tr("No fit yet: the readings are listed here once they fix an arc."));
  setFocusProxy(m_table);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_summary);
  layout->addWidget(m_table, 1);
  connect(m_table, &DataTable::rowActivated, this,
          [this](int index) { emit sightingActivated(row(index).position, row(index).reading); });
  m_summary->hide();
}

DataTable* ReliabilityPanel::createTable() {
  const auto whole = [this](int Row::*member) {
    return [this, member](int index) { return QString::number(row(index).*member); };
  };
  return new DataTable({
      {tr("Axis"), tr("Position of the axis"), QStringLiteral("180° again"),
       [this](int i) { return positionText(row(i).axisDeg, row(i).time); }},
      {tr("Point"), tr("Number of the slider's place"), QStringLiteral("999"), whole(&Row::point)},
      {tr("Round"), tr("Round of readings"), {}, whole(&Row::round)},
      {tr("Face"), tr("Face of the theodolite"), {}, whole(&Row::face)},
      {tr("Circle"), tr("What was read"), tr("horizontal"),
       [this](int i) { return circleText(row(i).adjusted.kind); }},
      {tr("Residual ″"), tr("Observed − adjusted; right and up positive"), QStringLiteral("−188.8"),
       [this](int i) { return numberText(Angle::fromRadians(row(i).adjusted.residual).arcseconds(), 1); }},
      {tr("Redundancy"),
       tr("Share of an error of this reading that shows in its own residual, 0 to 1"),
       {},
       [this](int i) { return numberText(row(i).adjusted.redundancy, 2); }},
      {tr("Detectable ″"),
       tr("Minimal detectable bias: the smallest error that a test of the residual finds with 80 % chance at "
          "0.1 % risk of a false alarm, with the stated σ"),
       QStringLiteral("1888.8"),
       [this](int i) { return numberText(row(i).reliability.minimalDetectableBias.arcseconds(), 1); }},
      {tr("Moves Δd by mm"), tr("What an error of that size, unfound, does to the intersection"),
       QStringLiteral("−0.0888"),
       [this](int i) { return signedNumberText(row(i).reliability.influence, 4); }},
  });
}

void ReliabilityPanel::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  m_summary->setText(summary());
  m_summary->setVisible(!readings().empty());
  m_table->setRows(static_cast<int>(readings().size()));
  showCurrent();
}

const std::vector<AdjustedReading>& ReliabilityPanel::readings() const {
  return m_evaluation->fit.joint.readings;
}

const ArcMeasurement& ReliabilityPanel::measuredArc(const AdjustedReading& adjusted) const {
  const auto& arcs = m_evaluation->examined.measurement->arcs;
  const std::size_t position = m_evaluation->fit.arcs[adjusted.arc].position;
  return *std::find_if(arcs.begin(), arcs.end(),
                       [&](const ArcMeasurement& measured) { return measured.position == position; });
}

ReliabilityPanel::Row ReliabilityPanel::row(int index) const {
  return rowOf(readings()[static_cast<std::size_t>(index)]);
}

ReliabilityPanel::Row ReliabilityPanel::rowOf(const AdjustedReading& adjusted) const {
  const ArcMeasurement& measured = measuredArc(adjusted);
  const Sighting& sighting = measured.sightings[adjusted.sighting];
  return {measured.position, sighting.row,  measured.axisDeg, measured.time,        sighting.round,
          sighting.point,    sighting.face, adjusted,         reliability(adjusted)};
}

Reliability ReliabilityPanel::reliability(const AdjustedReading& adjusted) const {
  Reliability reliability = reliabilityOf(adjusted);
  if (!m_evaluation->fit.intersection) reliability.influence = std::numeric_limits<double>::quiet_NaN();
  return reliability;
}

/// The reading whose unfound error would cost most.
QString ReliabilityPanel::summary() const {
  std::size_t unchecked = 0;
  const AdjustedReading* worst = nullptr;
  double most = 0;
  for (const AdjustedReading& adjusted : readings()) {
    const Reliability known = reliability(adjusted);
    if (!std::isfinite(known.minimalDetectableBias.radians())) ++unchecked;
    if (!(std::abs(known.influence) > most)) continue;
    most = std::abs(known.influence);
    worst = &adjusted;
  }
  if (unchecked > 0)
    return tr("%1 of %2 readings are checked by no other: an error in them would not show.")
        .arg(unchecked)
        .arg(readings().size());
  if (!worst) return {};
  const Row row = rowOf(*worst);
  return tr("Every reading is checked. The dearest unfound error: %1, point %2, %3, up to %4, moves Δd by "
            "%5.")
      .arg(positionText(row.axisDeg, row.time))
      .arg(row.point)
      .arg(circleText(row.adjusted.kind), arcsecText(row.reliability.minimalDetectableBias.arcseconds(), 0),
           lengthText(std::abs(row.reliability.influence), 3));
}

void ReliabilityPanel::setCurrentReading(std::size_t position, std::size_t row) {
  m_current = {position, row};
  showCurrent();
}

void ReliabilityPanel::showCurrent() {
  std::vector<int> rows;
  for (std::size_t i = 0; m_current && i < readings().size(); ++i) {
    const AdjustedReading& adjusted = readings()[i];
    if (m_evaluation->fit.arcs[adjusted.arc].position != m_current->first) continue;
    if (measuredArc(adjusted).sightings[adjusted.sighting].row == m_current->second)
      rows.push_back(static_cast<int>(i));
  }
  m_table->selectDataRows(rows);
}

}  // namespace alidade::ui

#include "ui/panels/uncertainty/reliability_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/statement/reliability.h"
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

QString inputText(const Unknown& input) {
  if (input.kind == Unknown::Kind::HorizontalZero) return ReliabilityPanel::tr("horizontal zero");
  if (input.kind == Unknown::Kind::VerticalZero) return ReliabilityPanel::tr("vertical zero");
  return input.kind == Unknown::Kind::Radius ? ReliabilityPanel::tr("known radius")
                                             : ReliabilityPanel::tr("distance");
}

QString axisText(const InputReliability& reliability, const SessionFit& fit) {
  if (!reliability.input.isPointingZero()) return notStated();
  if (reliability.input.arc == Unknown::everyArc) return ReliabilityPanel::tr("all");
  const ArcFit& arc = fit.arcs[reliability.input.arc];
  return positionText(arc.axisDeg, arc.repeat);
}

QString influenceText(const InputReliability& reliability, const SessionFit& fit) {
  if (!fit.intersection) return notStated();
  if (!reliability.input.isPointingZero())
    return ReliabilityPanel::tr("%1 per mm").arg(signedNumberText(reliability.perInput, 4));
  const double perArcsecond = reliability.perInput * Angle::fromArcseconds(1).radians();
  return ReliabilityPanel::tr("%1 per ″").arg(signedNumberText(perArcsecond, 4));
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
  m_table->setPlaceholder(tr("No fit yet: the readings are listed here once they determine an arc."));
  setFocusProxy(m_table);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_summary);
  layout->addWidget(m_table, 1);
  connect(m_table, &DataTable::rowActivated, this, [this](int index) {
    if (!input(index)) emit sightingActivated(row(index).position, row(index).reading);
  });
  m_summary->hide();
}

DataTable* ReliabilityPanel::createTable() {
  using Text = std::function<QString(const Row&)>;
  const auto ofReading = [this](const Text& text) {
    return [this, text](int i) { return input(i) ? notStated() : text(row(i)); };
  };
  const auto whole = [&](int Row::*member) {
    return ofReading([member](const Row& row) { return QString::number(row.*member); });
  };
  return new DataTable({
      {tr("Axis"), tr("Position of the axis"), QStringLiteral("180° again"),
       [this](int i) {
         if (!input(i)) return positionText(row(i).axisDeg, row(i).repeat);
         return axisText(*input(i), m_evaluation->fit);
       }},
      {tr("Point"), tr("Number of the slider's place"), QStringLiteral("999"), whole(&Row::point)},
      {tr("Round"), tr("Round of readings"), {}, whole(&Row::round)},
      {tr("Face"), tr("Face of the theodolite"), {}, whole(&Row::face)},
      {tr("Reading"), tr("The reading; quantities entered once follow after all readings"),
       tr("horizontal zero"),
       [this](int i) { return input(i) ? inputText(input(i)->input) : circleText(row(i).adjusted.kind); }},
      {tr("Residual ″"), tr("Observed − adjusted; right and up positive"), QStringLiteral("−188.8"),
       ofReading([](const Row& row) {
         return numberText(Angle::fromRadians(row.adjusted.residual).arcseconds(), 1);
       })},
      {tr("w"), tr("Standardised residual v/(s0 σ √r): for correct readings, its standard deviation is 1"),
       QStringLiteral("−18.88"), ofReading([this](const Row& row) {
         return numberText(row.adjusted.standardised(m_detection.scale), 2);
       })},
      {tr("Redundancy"),
       tr("Share of an error that shows in the reading's own residual, 0 to 1; 0: no other reading checks "
          "it"),
       {},
       [this](int i) { return numberText(input(i) ? input(i)->redundancy : row(i).adjusted.redundancy, 2); }},
      {tr("Detectable ″"),
       tr("Minimal detectable bias: the smallest error of this reading that the search for misread readings "
          "finds with a probability of 80 %; the risk of naming a correct reading anywhere in the session is "
          "1 %; assumed noise: s0 σ"),
       QStringLiteral("1888.8"),
       [this](int i) {
         const double bias = input(i) ? INFINITY : row(i).reliability.minimalDetectableBias.arcseconds();
         return std::isfinite(bias) ? numberText(bias, 1) : tr("none");
       }},
      {tr("Moves Δd by mm"),
       tr("Change of Δd by an undetected error of the size in “Detectable”; for quantities entered "
          "once, by an error of one unit"),
       QStringLiteral("−0.0888 per mm"),
       [this](int i) {
         if (!input(i)) return signedNumberText(row(i).reliability.influence, 4);
         return influenceText(*input(i), m_evaluation->fit);
       }},
  });
}

void ReliabilityPanel::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  const SessionFit& fit = evaluation->fit;
  m_detection = detectionIn(fit.joint, fit.noise.factor);
  m_inputs.clear();
  QStringList sentences;
  if (!fit.arcs.empty()) {
    const Measurement& measurement = *evaluation->examined.measurement;
    m_inputs = reliabilityOfInputs(measurement, fit);
    for (const std::string& sentence : reliabilityTable(measurement, fit).sentences)
      sentences.append(qText(sentence));
  }
  m_summary->setText(sentences.join(u' '));
  m_summary->setVisible(!sentences.isEmpty());
  m_table->setRows(static_cast<int>(readings().size() + m_inputs.size()));
  showCurrent();
}

const InputReliability* ReliabilityPanel::input(int index) const {
  const auto place = static_cast<std::size_t>(index);
  return place < readings().size() ? nullptr : &m_inputs[place - readings().size()];
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
  return {measured.position, sighting.row,  measured.axisDeg, measured.repeat,      sighting.round,
          sighting.point,    sighting.face, adjusted,         reliability(adjusted)};
}

Reliability ReliabilityPanel::reliability(const AdjustedReading& adjusted) const {
  Reliability reliability = reliabilityOf(adjusted, m_detection);
  if (!m_evaluation->fit.intersection) reliability.influence = std::numeric_limits<double>::quiet_NaN();
  return reliability;
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

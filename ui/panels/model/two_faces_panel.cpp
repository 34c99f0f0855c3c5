#include "ui/panels/model/two_faces_panel.h"

#include <QVBoxLayout>

#include "core/statement/two_faces.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

TwoFacesPanel::TwoFacesPanel(QWidget* parent)
    : QWidget(parent), m_errors(new StatementView), m_table(createTable()) {
  m_table->setAccessibleName(tr("Two-face table"));
  setFocusProxy(m_table);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_errors);
  layout->addWidget(m_table, 1);
  connect(m_table, &DataTable::rowActivated, this,
          [this](int index) { emit sightingActivated(row(index).position, row(index).reading); });
}

DataTable* TwoFacesPanel::createTable() {
  const auto whole = [this](int Row::*member) {
    return [this, member](int index) { return QString::number(row(index).*member); };
  };
  const auto seconds = [this](Angle FaceDifference::*member) {
    return [this, member](int index) {
      return signedNumberText((row(index).difference.*member).arcseconds(), 1);
    };
  };
  return new DataTable({
      {tr("Axis"), tr("Position of the axis"), QStringLiteral("180° again"),
       [this](int i) { return positionText(row(i).axisDeg, row(i).repeat); }},
      {tr("Point"), tr("Number of the slider's place"), QStringLiteral("999"), whole(&Row::point)},
      {tr("Round"), tr("Round of readings"), {}, whole(&Row::round)},
      {tr("Elevation °"), tr("Elevation above the pointing zero, mean of both faces"),
       QStringLiteral("−10.888"),
       [this](int i) { return numberText(row(i).difference.elevation.degrees(), 3); }},
      {tr("2c ″"), tr("α1 − (α2 ± 180°) = 2(c/cos e + i·tan e); c: collimation, i: trunnion tilt"),
       QStringLiteral("−188.8"), seconds(&FaceDifference::doubleCollimation)},
      {tr("2c residual ″"), tr("2c from the readings minus 2c from the fitted collimation and trunnion tilt"),
       QStringLiteral("−88.8"), seconds(&FaceDifference::fromCourse)},
      {tr("Index ″"), tr("Index error of the vertical circle: half of the difference β1 + β2 − nominal sum"),
       QStringLiteral("−188.8"), seconds(&FaceDifference::index)},
  });
}

void TwoFacesPanel::setEvaluation(const Evaluation& evaluation) {
  m_rows.clear();
  m_errors->setStatement(
      evaluation.twoFaces ? std::optional(transposed(instrumentErrors(*evaluation.twoFaces))) : std::nullopt);
  if (evaluation.twoFaces) {
    for (const FaceDifference& difference : evaluation.twoFaces->visits) {
      const ArcMeasurement& arc = evaluation.examined.measurement->arcs[difference.arc];
      const Sighting& sighting = arc.sightings[difference.faceOne];
      m_rows.push_back(
          {arc.position, sighting.row, arc.axisDeg, arc.repeat, sighting.round, sighting.point, difference});
    }
  }
  m_table->setRows(static_cast<int>(m_rows.size()));
}

}  // namespace alidade::ui

#include "core/answers/csv_answers.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "core/exchange/csv_text.h"
#include "core/statement/result_figures.h"

namespace alidade {

namespace {

constexpr double unknownNumber = std::numeric_limits<double>::quiet_NaN();  // an empty cell

class ResultsTable {
 public:
  explicit ResultsTable(double coverage) : m_coverage(coverage) {}

  /// `arc` is null for a quantity of the whole session.
  void add(std::string_view quantity, const ArcFit* arc, std::string_view unit, double value, double sigma,
           double expanded = unknownNumber) {
    m_csv.word(quantity);
    if (arc)
      m_csv.count(arc->axisDeg).count(arc->repeat);
    else
      m_csv.word("").word("");
    m_csv.word(unit).number(value).number(sigma).number(expanded);
    m_csv.number(expanded >= 0 ? m_coverage : unknownNumber).endRow();
  }

  void add(std::string_view quantity, const std::optional<MeasuredLength>& length) {
    if (length) add(quantity, nullptr, "mm", length->value, length->sigma, length->expanded);
  }

  const std::string& text() const { return m_csv.text(); }

 private:
  CsvText m_csv{"quantity", "axis_deg", "turn", "unit", "value", "sigma", "expanded", "coverage"};
  double m_coverage;
};

}  // namespace

std::string resultsCsv(const FitAnswer& answer) {
  ResultsTable table(answer.measurement.coverage);
  if (answer.diagnosis && answer.diagnosis->measured) {
    const MeasuredIntersection& measured = *answer.diagnosis->measured;
    table.add("intersection_as_measured", nullptr, "mm", measured.estimate.value, measured.estimate.sigma,
              measured.estimate.expanded);
    for (const MeasuredFigure& figure : measuredFigures()) table.add(figure.id, measured.*figure.length);
  }
  const SessionFit& fit = answer.fit;
  if (const auto& found = fit.intersection) {
    table.add("intersection_of_fit", nullptr, "mm", found->value, found->sigma, found->expanded);
    table.add("in_plane", nullptr, "mm", found->inPlane, found->inPlaneSigma, found->inPlaneExpanded);
  }
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcSummary summary = summaryOf(fit.arcs[i], fit.sigmas[i]);
    for (const ArcFigure& figure : arcFigures())
      table.add(figure.id, &fit.arcs[i], figure.unit, figure.value(summary),
                figure.sigma ? figure.sigma(summary) : unknownNumber);
  }
  return table.text();
}

}  // namespace alidade

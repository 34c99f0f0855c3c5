#include "core/answers/csv_answers.h"

#include <limits>
#include <string_view>
#include <vector>

#include "core/exchange/csv_text.h"
#include "core/wording/budget.h"

namespace alidade {

namespace {

double shareOf(double sigma, double variance) {
  return variance > 0 ? sigma * sigma / variance : std::numeric_limits<double>::quiet_NaN();
}

class BudgetTable {
 public:
  void addMeasured(const MeasuredIntersection& measured) {
    const double variance = measured.estimate.sigma * measured.estimate.sigma;
    for (const UncertaintyShare& share : measured.budget) {
      beginRow("intersection_as_measured", nullptr).word(textOf(share)).word(textOf(share.type));
      m_csv.word(textOf(share.from)).number(share.sigma).number(shareOf(share.sigma, variance));
      m_csv.number(share.degreesOfFreedom).word(sizesText(share)).typed(share.reference).endRow();
    }
  }

  /// `arc` is null for a quantity of the whole session.
  void add(std::string_view quantity, const ArcFit* arc, const std::vector<BudgetEntry>& entries) {
    double variance = 0;
    for (const BudgetEntry& entry : entries) variance += entry.sigma * entry.sigma;
    for (const BudgetEntry& entry : entries) {
      beginRow(quantity, arc).word(textOf(entry.source)).word("").word("").number(entry.sigma);
      m_csv.number(shareOf(entry.sigma, variance)).word("").word("").word("").endRow();
    }
  }

  const std::string& text() const { return m_csv.text(); }

 private:
  CsvText& beginRow(std::string_view quantity, const ArcFit* arc) {
    m_csv.word(quantity);
    if (arc) return m_csv.count(arc->axisDeg).count(arc->repeat);
    return m_csv.word("").word("");
  }

  CsvText m_csv{"quantity", "axis_deg",           "turn", "source",   "type", "from", "sigma_mm",
                "share",    "degrees_of_freedom", "size", "reference"};
};

}  // namespace

std::string budgetCsv(const SessionFit& fit, const Diagnosis* found) {
  BudgetTable table;
  if (found && found->measured) table.addMeasured(*found->measured);
  if (fit.intersection) table.add("intersection_of_fit", nullptr, fit.intersection->budget);
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    table.add("x", &fit.arcs[i], fit.budgets[i].x);
    table.add("y", &fit.arcs[i], fit.budgets[i].y);
    table.add("radius", &fit.arcs[i], fit.budgets[i].radius);
  }
  return table.text();
}

}  // namespace alidade

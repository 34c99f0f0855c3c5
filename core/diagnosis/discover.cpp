#include "core/diagnosis/discover.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/forms/held_out_forms.h"
#include "core/diagnosis/forms/residual_table.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Returns an orthonormal basis of the base columns; one column of zeros if these are absent or all zero.
MatrixXd basisOf(const MatrixXd& base) {
  if (base.cols() == 0 || base.isZero()) return MatrixXd::Zero(base.rows(), 1);
  const VectorXd scale = base.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(base * scale.asDiagonal());
  return qr.householderQ() * MatrixXd::Identity(base.rows(), qr.rank());
}

MatrixXd asTheyAre(const MatrixXd& columns) {
  return columns;
}

class TableForms {
 public:
  explicit TableForms(const ResidualTable& table) : m_table(table), m_basis(basisOf(table.base)) {
    m_left = table.residual - m_basis * (m_basis.transpose() * table.residual).eval();
    const Index rank = m_basis.isZero() ? 0 : m_basis.cols();
    m_freedom = static_cast<double>(table.readings.count - rank);
  }

  double freedom() const { return m_freedom; }

  Discovery find() const {
    Discovery discovery{.readings = static_cast<int>(m_table.readings.count),
                        .rms = rmsOf(m_left, m_table.sigma),
                        .reducedChiSquare = m_left.squaredNorm() / m_freedom,
                        .forms = {}};
    // Stated σ are often too small: the residuals after the forms give the scatter.
    const std::vector<FormFamily> families = formFamilies(m_table.readings);
    double variance = std::max(1.0, discovery.reducedChiSquare);
    FoundForms found;
    for (int round = 0; round < 2; ++round) {
      FormSystem system = systemWith(variance);
      found = search(system, families);
      variance = std::max(1.0, system.left().squaredNorm() / std::max(1.0, m_freedom - found.numbers));
    }
    discovery.noise = std::sqrt(variance);
    addShrinkage(found, variance);
    discovery.forms = std::move(found.forms);
    return discovery;
  }

 private:
  const ResidualTable& m_table;
  MatrixXd m_basis;
  VectorXd m_left;
  double m_freedom = 0;

  FormSystem systemWith(double variance) const { return {asTheyAre, m_basis, m_left, variance}; }

  FoundForms search(FormSystem& system, const std::vector<FormFamily>& families) const {
    return findForms(system, m_table.readings, families,
                     {.isNamed = beatNothing,
                      .isAnythingLeft = [](int) { return true; },
                      .note = [](const WeighedForm&, FoundForm&) {}},
                     {});
  }

  void addShrinkage(FoundForms& found, double variance) const {
    constexpr int folds = 4;
    if (found.forms.empty()) return;
    const DividedModel model{asTheyAre, m_basis, m_left};
    const HeldOutReadings held{.fold = shuffledFolds(static_cast<std::size_t>(m_left.size()), folds),
                               .folds = folds,
                               .arcseconds = m_table.sigma,
                               .eliminated = std::vector<int>(folds, 0)};
    alidade::addShrinkage(found, model, model, held, m_table.readings, variance, {});
  }
};

}  // namespace

Result<Discovery> discover(std::string_view bytes) {
  const Result<ResidualTable> table = readResiduals(bytes);
  if (!table) return table.problem();
  const TableForms forms(*table);
  if (forms.freedom() < 1)
    return Problem{Phrase::of(
        "The base columns leave no degree of freedom in the %1 residuals: leave out some of the columns.",
        table->readings.count)};
  return forms.find();
}

}  // namespace alidade

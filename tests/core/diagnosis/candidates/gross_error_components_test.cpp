#include "core/diagnosis/candidates/gross_error_components.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Leftover leftoverAfter(const GapModel& model) {
  return Leftover(linearise(*model.measurement, *model.fit, model.options));
}

/// The projector on the complement of all unknowns together: an arc angle for each visit, and unknowns that
/// are not exact. Their prior knowledge counts as readings.
MatrixXd projectorOf(const Linearised& equations) {
  const std::vector<std::size_t> unknowns = equations.uncertainUnknowns();
  const std::vector<PriorRow> priors = equations.priorRows(unknowns, {});
  const Index readings = std::ssize(equations.readings), visits = static_cast<Index>(equations.visits);
  MatrixXd design = MatrixXd::Zero(readings + std::ssize(priors), visits + std::ssize(unknowns));
  for (Index i = 0; i < readings; ++i) {
    const LinearReading& reading = equations.readings[static_cast<std::size_t>(i)];
    design(i, static_cast<Index>(reading.visit)) = reading.along;
    for (Index u = 0; u < std::ssize(unknowns); ++u)
      design(i, visits + u) =
          equations.ofUnknown(static_cast<std::size_t>(i), unknowns[static_cast<std::size_t>(u)]);
  }
  for (Index row = readings; const PriorRow& prior : priors)
    design(row++, visits + static_cast<Index>(prior.column)) = prior.derivative;
  for (auto column : design.colwise())
    if (column.norm() > 0) column.normalize();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(design);
  const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(design.rows(), qr.rank());
  return MatrixXd::Identity(design.rows(), design.rows()) - basis * basis.transpose();
}

// The visible share of an error, from a projector without special treatment of visits or arc angles. Rounding
// errors of some hundred columns are 1e-12.
TEST(GrossErrorComponents, AreEveryReadingInItsOrder) {
  for (const char* protocol : {"paper", "paper-slider", "full"}) {
    SCOPED_TRACE(protocol);
    const Leftover leftover = leftoverAfter(*modelOf(test::trialMeasurement(protocol)));
    const std::vector<GrossErrorComponent> components = grossErrorComponents(leftover);
    const MatrixXd projector = projectorOf(leftover.equations());
    ASSERT_EQ(std::ssize(components), leftover.readings());
    for (Index i = 0; i < leftover.readings(); ++i) {
      const GrossErrorComponent& component = components[static_cast<std::size_t>(i)];
      EXPECT_EQ(component.grossErrorAt(), i);
      EXPECT_EQ(component.gram().size(), 1);
      EXPECT_NEAR(component.gram()(0, 0), projector(i, i), 1e-12);
      const VectorXd visible = component.visibleColumns(leftover);
      EXPECT_LT((visible - projector.col(i)).norm(), 1e-12);
      for (const double weight : {-8.0, 120.0})
        EXPECT_NEAR(component.signatureLength(VectorXd::Constant(1, weight)),
                    std::abs(weight) * visible.norm(), 1e-12 * std::abs(weight));
    }
  }
}

// The ray tracer's misread readings, 30″ and 300″. The reading whose error alone reduces χ² most is the
// misread one, and its error is right within 4 σ. Without that reading χ² decreases by the same amount, to
// 1e-4, because the fit is almost linear over 300″.
TEST(GrossErrorComponents, PointAtTheReadingThatIsOff) {
  int found = 0;
  for (const test::Trial& trial : test::trials()) {
    if (trial.kind != "gross_error") continue;
    SCOPED_TRACE(trial.id);
    GapModel model = *modelOf(trial.measurement);
    const Leftover leftover = leftoverAfter(model);
    const std::vector<GrossErrorComponent> components = grossErrorComponents(leftover);
    const SharedProducts left(leftover, leftover.residual());
    const auto taken = [&](const GrossErrorComponent& component) {
      return std::pow(component.products(left)[0], 2) / component.gram()(0, 0);
    };
    const GrossErrorComponent& most = *std::ranges::max_element(components, std::ranges::less(), taken);
    const LinearReading& reading = leftover.reading(*most.grossErrorAt());
    const Sighting& sighting = trial.measurement.arcs[reading.arc].sightings[reading.sighting];
    const auto& grossError = trial.truth.at("blunders").at(0);
    EXPECT_EQ(grossError.at(0), reading.arc);
    EXPECT_EQ(grossError.at(1), sighting.round);
    EXPECT_EQ(grossError.at(2), sighting.point);
    EXPECT_EQ(grossError.at(3), sighting.face);
    const bool isHorizontal = reading.kind == ReadingKind::Horizontal;
    const double side = isHorizontal ? 1 : -1;  // zenith readings increase downwards
    EXPECT_NEAR(side * most.products(left)[0] / most.gram()(0, 0),
                grossError.at(isHorizontal ? 4 : 5).get<double>() / 2, 4 / std::sqrt(most.gram()(0, 0)));
    const double before = model.fit->chiSquare;
    most.addTo(model.options, leftover, VectorXd::Zero(1), 8);
    EXPECT_EQ(model.options.without,
              (std::vector<ReadingRef>{{reading.arc, reading.sighting, reading.kind}}));
    EXPECT_TRUE(model.options.terms.empty());
    model.refit();
    EXPECT_NEAR(before - model.fit->chiSquare, taken(most), 1e-4 * taken(most));
    // A reading that is excluded from the model cannot have a gross error.
    const Leftover after = leftoverAfter(model);
    EXPECT_EQ(grossErrorComponents(after)[static_cast<std::size_t>(*most.grossErrorAt())].gram()(0, 0), 0);
    ++found;
  }
  EXPECT_EQ(found, 3);
}

// The search bounds rely on the first width as the narrowest.
TEST(GrossErrorComponents, HaveTheirWidthsTheNarrowestFirst) {
  EXPECT_TRUE(std::ranges::is_sorted(grossErrorWidths(), std::ranges::less(), &Width::sigma));
  EXPECT_EQ(&GrossErrorComponent(3, 0.5).widths(), &grossErrorWidths());
}

}  // namespace
}  // namespace alidade

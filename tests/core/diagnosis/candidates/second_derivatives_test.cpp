#include "core/diagnosis/candidates/second_derivatives.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/simulate.h"
#include "tests/support/full_leftover.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using test::greatest;

GapModel modelOfSession(const std::string& protocol, const std::vector<std::string>& effects) {
  Session session = *simulate(*protocolByName(protocol), drawTruth(7), 7);
  session.model.effects = effects;
  return *modelOf(*examine(session).measurement);
}

/// ∂reading/∂term by automatic derivatives, whitened, with the plane tilted.
VectorXd derivative(const GapModel& model, ErrorTerm by, ErrorTerm tilt, double size) {
  JointFit tilted = *model.fit;
  tilted.unknowns.push_back({.kind = Unknown::Kind::Error, .arc = 0, .term = tilt});
  tilted.values.push_back(size);
  const Linearised equations = linearise(*model.measurement, tilted, model.options);
  VectorXd column(static_cast<Index>(equations.readings.size()));
  for (Index i = 0; i < column.size(); ++i) column[i] = equations.ofTerm(static_cast<std::size_t>(i), by);
  return column;
}

// Automatic first derivatives at tilts of ± a thousandth of a plausible size: their differences are second
// derivatives to seven digits. Differences over a plausible size, 0.005 rad, err by the step times the third
// derivatives. These do not exceed the first derivatives by both tilts together.
TEST(SecondDerivatives, AreHowTheFirstOnesChange) {
  const Effect& tilt = *effectById("plane_tilt");
  const std::vector<EffectParameter>& tilts = tilt.parameters;
  for (const auto& [protocol, effects] : {std::pair<std::string, std::vector<std::string>>{"full", {}},
                                          {"two-face", {"collimation", "vertical_index"}},
                                          {"paper", {}}}) {
    SCOPED_TRACE(protocol);
    const GapModel model = modelOfSession(protocol, effects);
    const Leftover leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
    const MatrixXd columns = secondDerivatives(model, leftover, tilt);
    ASSERT_EQ(columns.rows(), leftover.readings());
    const std::array<std::pair<int, int>, 3> pairs{{{0, 0}, {0, 1}, {1, 1}}};
    for (std::size_t c = 0; c < pairs.size(); ++c) {
      const EffectParameter& first = tilts[static_cast<std::size_t>(pairs[c].first)];
      const EffectParameter& second = tilts[static_cast<std::size_t>(pairs[c].second)];
      const double step = plausibleSize(second) / 1000;
      const VectorXd change = derivative(model, first.term, second.term, step) -
                              derivative(model, first.term, second.term, -step);
      const VectorXd expected = change / (2 * step) * plausibleSize(first) * plausibleSize(second);
      ASSERT_GT(expected.norm(), 1);
      const double third = std::pow(plausibleSize(second), 3) * (greatest(leftover.column(tilts[0].term)) +
                                                                 greatest(leftover.column(tilts[1].term)));
      EXPECT_LT(greatest(columns.col(static_cast<Index>(c)) - expected), third + 1e-6 * greatest(expected))
          << greatest(expected);
    }
  }
}

}  // namespace
}  // namespace alidade

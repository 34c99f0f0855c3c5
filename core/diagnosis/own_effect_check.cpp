#include "core/diagnosis/own_effect_check.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/gap/leftover.h"
#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"
#include "core/observation/own_model.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd;

constexpr double nothing = 0.1;  // σ

MatrixXd visibleColumns(const Leftover& leftover, const Effect& effect) {
  return EffectComponent(effect, {}).visibleColumns(leftover);
}

/// The catalogued effect whose columns nearly span `columns`; empty: none.
std::string sameAs(const Leftover& leftover, const MatrixXd& columns) {
  constexpr double alike = 3, mostLeft = 0.3, hardlySeen = 1;  // σ; share of the visible length; σ
  std::string same;
  if (columns.norm() < hardlySeen) return same;
  double least = std::min(alike, mostLeft * columns.norm());
  for (const Effect& effect : effectCatalogue()) {
    if (!hasSizes(effect)) continue;
    const MatrixXd others = visibleColumns(leftover, effect);
    const double left = (columns - others * others.completeOrthogonalDecomposition().solve(columns)).norm();
    if (left >= least) continue;
    least = left;
    same = effect.id;
  }
  return same;
}

/// Counts all values of the lines at the fitted arc angles of the rows, and those that are not finite.
void count(OwnEffectCheck& check, const Measurement& measurement, const SessionFit& fit,
           const OwnEntry& entry) {
  std::vector<OwnEntry> one{entry};
  const OwnModel model(std::make_shared<const OwnEffects>(std::move(one)));
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    const ArcMeasurement& own = measurement.arcs[arc];
    const Circle circle = fit.joint.circleOf(arc);
    for (std::size_t i = 0; i < own.sightings.size(); ++i) {
      const Sighting& row = own.sightings[i];
      const double phi = fit.joint.arcAngles[arc][i];
      const OwnPlace place = model.placeOf(measurement, own, row, phi);
      if (!row.isZero)
        check.values += model
                            .ofGuideway(place, {circle.x, circle.y}, circle.radius, measurement.distance, phi,
                                        own.axisDeg)
                            .size();
      check.values +=
          model.ofCircles(place, row.a.radians(), row.e.radians() + own.zeroElevation.radians()).size();
    }
  }
  check.notFinite = model.notFinite();
  check.values += check.notFinite;
}

}  // namespace

bool OwnEffectCheck::leavesNothing() const {
  return std::ranges::all_of(parameters, [](const OwnVisibility& own) { return own.plausible < nothing; });
}

std::vector<std::string> OwnEffectCheck::sentences() const {
  std::vector<std::string> texts;
  if (notFinite > 0)
    texts.push_back(Phrase::of(
        "In %1 of %2 evaluations at these readings, the formula has no finite value: 0 is used instead.",
        notFinite, values));
  if (leavesNothing())
    texts.push_back(
        Phrase::of("This effect is undetectable here, as the fit absorbs it: its trace is %1 σ per %2.",
                   fixedText(parameters.front().perUnit, 1), parameters.front().unit));
  if (!sameAs.empty())
    texts.push_back(
        Phrase::of("This effect has nearly the same trace as %1 of the catalogue: these readings cannot "
                   "distinguish the two.",
                   quotation(Phrase::of(effectById(sameAs)->name))));
  return texts;
}

std::optional<OwnEffectCheck> checkOwnEffect(const Measurement& measurement, const std::string& id) {
  if (!measurement.own) return std::nullopt;
  const auto& entries = measurement.own->entries();
  const auto entry = std::ranges::find(entries, id, &OwnEntry::id);
  if (entry == entries.end()) return std::nullopt;
  const SessionFit fit = fitSession(measurement);
  const Result<GapModel, NoModel> found = modelOf(measurement, fit);
  if (!found) return std::nullopt;
  GapModel model = *found;
  // As an estimated term, the effect absorbs its own trace.
  std::erase_if(model.options.terms, [&](const EstimatedTerm& term) {
    return std::ranges::find(entry->terms, term.term) != entry->terms.end();
  });
  model.refit();
  if (!model.fit->isDetermined()) return std::nullopt;
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
  const MatrixXd columns = visibleColumns(leftover, entry->effect);
  OwnEffectCheck check;
  Index column = 0;
  for (const EffectParameter& parameter : entry->effect.parameters) {
    const double visible = columns.col(column++).norm();
    check.parameters.push_back(
        {std::string(parameter.name), std::string(parameter.unit), visible / parameter.plausible, visible});
  }
  count(check, *model.measurement, fit, *entry);
  check.curves = curvesOf(*entry, *model.measurement, fit);
  if (!check.leavesNothing()) check.sameAs = sameAs(leftover, columns);
  return check;
}

std::optional<OwnEffectCheck> checkOwnEffect(Measurement measurement, const OwnEffect& effect) {
  std::vector<Problem> problems;
  measurement.own = examineOwnEffects({effect}, problems);
  std::erase_if(measurement.effects, [](const std::string& id) { return id.starts_with(ownPrefix); });
  return checkOwnEffect(measurement, ownId(effect));
}

}  // namespace alidade

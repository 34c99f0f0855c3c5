#include "core/diagnosis/own_effect_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/observation/own_model.h"
#include "core/terms/formula_text.h"

namespace alidade {

namespace {

using Variable = double FormulaArguments::*;

/// The arguments at each sighting, in the order of the session.
std::vector<FormulaArguments> placesOf(const Measurement& measurement, const SessionFit& fit) {
  const OwnModel model(nullptr);
  std::vector<FormulaArguments> places;
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    const ArcMeasurement& own = measurement.arcs[arc];
    for (std::size_t i = 0; i < own.sightings.size(); ++i) {
      const Sighting& row = own.sightings[i];
      const OwnPlace place = model.placeOf(measurement, own, row, fit.joint.arcAngles[arc][i]);
      places.push_back(argumentsAt(place, row.a.radians(), row.e.radians() + own.zeroElevation.radians()));
    }
  }
  return places;
}

bool hasFewValues(Variable variable) {
  constexpr Variable few[] = {&FormulaArguments::leg, &FormulaArguments::round, &FormulaArguments::face,
                              &FormulaArguments::position};
  return std::ranges::find(few, variable) != std::end(few);
}

/// 1 for what is no angle.
double unitsPerRadian(Variable variable) {
  return variable == &FormulaArguments::t || hasFewValues(variable) ? 1 : 180 / std::numbers::pi;
}

/// The places in order of the variable: its values, or many between its first and last.
std::vector<FormulaArguments> along(Variable variable, std::vector<FormulaArguments> places) {
  constexpr int steps = 200;
  std::ranges::sort(places, {}, variable);
  if (hasFewValues(variable)) {
    const auto isEqual = [&](const auto& one, const auto& other) { return one.*variable == other.*variable; };
    places.erase(std::unique(places.begin(), places.end(), isEqual), places.end());
    return places;
  }
  std::vector<FormulaArguments> all(steps + 1, places.front());
  for (int i = 0; i <= steps; ++i)
    all[static_cast<std::size_t>(i)].*variable =
        std::lerp(places.front().*variable, places.back().*variable, static_cast<double>(i) / steps);
  return all;
}

/// The one variable of all lines; null: they have several, or none.
Variable variableOf(const Formula& formula) {
  const std::vector<Variable>& first = formula.lines.front().variables;
  const auto isOfFirst = [&](const FormulaLine& line) { return line.variables == first; };
  return first.size() == 1 && std::ranges::all_of(formula.lines, isOfFirst) ? first.front() : nullptr;
}

}  // namespace

std::vector<OwnCurve> curvesOf(const OwnEntry& entry, const Measurement& measurement, const SessionFit& fit) {
  const std::vector<FormulaArguments> places = placesOf(measurement, fit);
  if (places.empty()) return {};
  const Variable variable = variableOf(entry.formula);
  const std::vector<FormulaArguments> at = variable ? along(variable, places) : places;
  const FormulaEvaluator evaluator(entry.formula);
  std::vector<OwnCurve> curves;
  for (std::size_t l = 0; l < entry.formula.lines.size(); ++l) {
    const FormulaLine& line = entry.formula.lines[l];
    OwnCurve& curve = curves.emplace_back();
    curve.carrier = line.carrier;
    if (variable)
      curve.variable = std::ranges::find(formulaVariables, variable, &FormulaVariable::value)->name;
    for (std::size_t i = 0; i < at.size(); ++i) {
      double sum = 0;
      for (const std::size_t amplitude : line.amplitudes)
        sum += entry.effect.parameters[amplitude].plausible * evaluator.value(l, amplitude, at[i]);
      const double x = variable ? at[i].*variable * unitsPerRadian(variable) : static_cast<double>(i + 1);
      if (std::isfinite(sum)) curve.points.push_back({x, sum});
    }
  }
  return curves;
}

}  // namespace alidade

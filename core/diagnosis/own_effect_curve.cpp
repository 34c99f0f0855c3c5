#include "core/diagnosis/own_effect_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/observation/own_model.h"

namespace alidade {

namespace {

using Kind = FormulaVariable::Kind;

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

/// The one variable of all lines; null if the lines have several variables or none.
const FormulaVariable* variableOf(const Formula& formula) {
  const auto& first = formula.lines.front().variables;
  const auto isOfFirst = [&](const FormulaLine& line) { return line.variables == first; };
  if (first.size() != 1 || !std::ranges::all_of(formula.lines, isOfFirst)) return nullptr;
  return std::ranges::find(formulaVariables, first.front(), &FormulaVariable::value);
}

struct At {
  double x;
  FormulaArguments arguments;
};

/// The distinct values of a counted variable, or 201 values over the range of another variable.
std::vector<At> along(const FormulaVariable& variable, const std::vector<FormulaArguments>& places) {
  constexpr int steps = 200;
  std::vector<double> values;
  for (const FormulaArguments& place : places) values.push_back(place.*variable.value);
  std::ranges::sort(values);
  if (variable.kind == Kind::Counted) {
    values.erase(std::unique(values.begin(), values.end()), values.end());
  } else {
    const double least = values.front(), largest = values.back();
    values.clear();
    for (int i = 0; i <= steps; ++i) values.push_back(std::lerp(least, largest, double(i) / steps));
  }
  std::vector<At> all;
  for (const double value : values) {
    At& at = all.emplace_back();
    at.x = variable.kind == Kind::Angle ? value * 180 / std::numbers::pi : value;
    at.arguments.*variable.value = value;
  }
  return all;
}

/// The sightings in order; only every n-th one if there are very many.
std::vector<At> inOrder(const std::vector<FormulaArguments>& places) {
  constexpr std::size_t most = 1000;
  std::vector<At> all;
  for (std::size_t i = 0; i < places.size(); i += 1 + places.size() / most) {
    At& at = all.emplace_back();
    at.x = static_cast<double>(i + 1);
    at.arguments = places[i];
  }
  return all;
}

}  // namespace

std::vector<OwnCurve> curvesOf(const OwnEntry& entry, const Measurement& measurement, const SessionFit& fit) {
  const std::vector<FormulaArguments> places = placesOf(measurement, fit);
  if (places.empty()) return {};
  const FormulaVariable* variable = variableOf(entry.formula);
  const std::vector<At> all = variable ? along(*variable, places) : inOrder(places);
  const FormulaEvaluator evaluator(entry.formula);
  std::vector<OwnCurve> curves;
  for (std::size_t l = 0; l < entry.formula.lines.size(); ++l) {
    const FormulaLine& line = entry.formula.lines[l];
    OwnCurve& curve = curves.emplace_back();
    curve.carrier = line.carrier;
    curve.variable = variable;
    for (const At& at : all) {
      double sum = 0;
      for (const std::size_t amplitude : line.amplitudes)
        sum += entry.effect.parameters[amplitude].plausible * evaluator.value(l, amplitude, at.arguments);
      if (std::isfinite(sum)) curve.points.push_back({at.x, sum});
    }
  }
  return curves;
}

}  // namespace alidade

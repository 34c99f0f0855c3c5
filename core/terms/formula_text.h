#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/terms/formula.h"

namespace alidade {

/// A function that expressions may call.
struct FormulaFunction {
  std::string_view name;
  int arguments;
};
inline constexpr FormulaFunction formulaFunctions[] = {
    {"bump", 3}, {"step", 2}, {"hinge", 2}, {"exponential", 2}, {"sin", 1},  {"cos", 1},  {"tan", 1},
    {"asin", 1}, {"acos", 1}, {"atan", 1},  {"atan2", 2},       {"exp", 1},  {"ln", 1},   {"sqrt", 1},
    {"abs", 1},  {"sign", 1}, {"min", 2},   {"max", 2},         {"sinh", 1}, {"cosh", 1}, {"tanh", 1},
};

/// A variable of expressions, and the argument that is its value.
struct FormulaVariable {
  enum class Kind {
    Angle,   ///< rad
    Share,   ///< 0…1
    Counted  ///< a small whole number
  };

  std::string_view name;
  double FormulaArguments::*value;
  bool isOfZerosToo;  ///< also defined for a pointing zero
  Kind kind = Kind::Angle;
};
inline constexpr FormulaVariable formulaVariables[] = {
    {"s", &FormulaArguments::s, false},
    {"t", &FormulaArguments::t, true, FormulaVariable::Kind::Share},
    {"a", &FormulaArguments::a, true},
    {"e", &FormulaArguments::e, true},
    {"horizontal_circle", &FormulaArguments::horizontalCircle, true},
    {"vertical_circle", &FormulaArguments::verticalCircle, true},
    {"alpha", &FormulaArguments::horizontalCircle, true},
    {"beta", &FormulaArguments::verticalCircle, true},
    {"leg", &FormulaArguments::leg, false, FormulaVariable::Kind::Counted},
    {"round", &FormulaArguments::round, false, FormulaVariable::Kind::Counted},
    {"face", &FormulaArguments::face, true, FormulaVariable::Kind::Counted},
    {"position", &FormulaArguments::position, false, FormulaVariable::Kind::Counted},
};

/// A name in an expression, and its place in the text.
struct FormulaName {
  std::string_view name;
  std::size_t at;
};

/// One line of a formula's text: `name = …`.
struct FormulaStatement {
  FormulaName name;
  std::string_view expression;
  std::size_t at = 0;  ///< place of the expression in the text
};

/// The lines of the text that are not blank.
Result<std::vector<FormulaStatement>, FormulaFault> formulaStatements(std::string_view text);

/// An expression for the parser: every character was checked, degrees are converted to radians, and names of
/// numbers are replaced by their values.
struct PlainExpression {
  std::string text;
  std::vector<FormulaName> variables, amplitudes;  ///< each occurrence
};
Result<PlainExpression, FormulaFault> plainExpression(const FormulaStatement& statement,
                                                      const std::map<std::string_view, double>& numbers);

}  // namespace alidade

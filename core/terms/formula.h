#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/terms/carrier.h"

namespace alidade {

// The formulas of the user's own effects, such as
//
//   radial = A*bump(s, 83°, w); w = 4°
//
// Lines end with a semicolon or a line break. A line is `carrier = expression`, or `name = number`, which
// gives a number a name. Names that are neither variables nor names of numbers are amplitudes: the
// expressions are linear in them, which is checked. Angles are in radians; a number with ° or deg counts
// degrees. Formulas may come from unknown people: their length is limited, they have no loops, strings or
// assignments, and the parser (muParser) sees only text that was checked before.

/// "mm" or "arcsec".
std::string_view unitOf(FormCarrier carrier);

/// The variables of a formula for one reading; angles in rad.
struct FormulaArguments {
  double s = 0;                 ///< slider coordinate; 0 for a pointing zero
  double t = 0;                 ///< elapsed share of the session, 0…1
  double a = 0, e = 0;          ///< azimuth from the pointing zero, elevation over the horizon, in face 1
  double horizontalCircle = 0;  ///< as read in `face`, like `verticalCircle`
  double verticalCircle = 0;
  double leg = 1;       ///< 1 in odd rounds, −1 in even rounds
  double round = 1;     ///< from 1
  double face = 1;      ///< 1 in face 1, −1 in face 2
  double position = 1;  ///< 1 at axis 0°, −1 at 180°
};

/// The reason why a text is not a formula, and the place of the fault.
struct FormulaFault {
  std::size_t at = 0, length = 0;  ///< bytes of the UTF-8 text; length 0: a part is missing at `at`
  std::string what;                ///< a sentence, without the place

  /// The sentence, preceded by line and column. Both count from 1, columns in characters.
  std::string text(std::string_view formula) const;
};

struct FormulaLine {
  FormCarrier carrier = FormCarrier::Radial;
  std::string expression;               ///< for the parser
  std::vector<std::size_t> amplitudes;  ///< indices into `Formula::amplitudes`
  /// False if the line uses the slider coordinate, leg, round or position. If true, a line on circles acts on
  /// pointing zeros as well.
  bool actsOnZeros = true;
  std::vector<double FormulaArguments::*> variables = {};  ///< each once

  bool isOfTime() const { return std::ranges::find(variables, &FormulaArguments::t) != variables.end(); }
};

struct FormulaAmplitude {
  std::string name;
  FormCarrier carrier = FormCarrier::Radial;  ///< of the first line that contains it
};

/// A formula that passed all checks. Immutable, and shared between threads.
struct Formula {
  std::vector<FormulaLine> lines = {};
  std::vector<FormulaAmplitude> amplitudes = {};
};

inline constexpr std::size_t longestFormula = 500;  ///< bytes

/// Parses and checks a formula, in about 0.2 ms.
Result<Formula, FormulaFault> parseFormula(std::string_view text);

/// Evaluates the lines of a formula. Not thread-safe.
class FormulaEvaluator {
 public:
  explicit FormulaEvaluator(const Formula& formula);
  FormulaEvaluator(FormulaEvaluator&&) noexcept;
  ~FormulaEvaluator();

  /// The effect of one unit of an amplitude on the carrier of a line. NaN if the value is not a number or its
  /// size exceeds 10⁶.
  double value(std::size_t line, std::size_t amplitude, const FormulaArguments& at) const;

 private:
  friend class LinearityCheck;
  struct Parsers;
  std::unique_ptr<Parsers> m_parsers;
};

}  // namespace alidade

#include "core/terms/formula.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/random_source.h"
#include "core/base/visible_text.h"
#include "core/terms/error_term.h"
#include "core/terms/formula_text.h"

namespace alidade {

namespace {

double bump(double x, double at, double width) {
  const double off = (x - at) / width;
  return std::exp(-off * off / 2);
}
double step(double x, double at) {
  return x > at ? 1 : 0;
}
double hinge(double x, double at) {
  return std::max(0.0, x - at);
}
double exponential(double x, double tau) {
  return std::exp(-x / tau);
}
double smaller(double x, double y) {
  return std::min(x, y);
}
double larger(double x, double y) {
  return std::max(x, y);
}
double signOf(double x) {
  return static_cast<double>((x > 0) - (x < 0));
}

/// A parser that knows the functions of formulas and nothing else.
mu::Parser bareParser() {
  mu::Parser parser;
  parser.ClearFun();
  parser.ClearConst();
  parser.DefineFun("bump", bump);
  parser.DefineFun("step", step);
  parser.DefineFun("hinge", hinge);
  parser.DefineFun("exponential", exponential);
  parser.DefineFun("min", smaller);
  parser.DefineFun("max", larger);
  parser.DefineFun("sign", signOf);
  parser.DefineFun("atan2", static_cast<double (*)(double, double)>(std::atan2));
  using OfOne = double (*)(double);
  for (const auto& [name, function] :
       std::initializer_list<std::pair<const char*, OfOne>>{{"sin", std::sin},
                                                            {"cos", std::cos},
                                                            {"tan", std::tan},
                                                            {"asin", std::asin},
                                                            {"acos", std::acos},
                                                            {"atan", std::atan},
                                                            {"exp", std::exp},
                                                            {"ln", std::log},
                                                            {"sqrt", std::sqrt},
                                                            {"abs", std::fabs},
                                                            {"sinh", std::sinh},
                                                            {"cosh", std::cosh},
                                                            {"tanh", std::tanh}})
    parser.DefineFun(name, function);
  return parser;
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::string_view unitOf(FormCarrier carrier) {
  return carrier <= FormCarrier::Z ? "mm" : "arcsec";
}

std::string FormulaFault::text(std::string_view formula) const {
  std::size_t line = 1, column = 1;
  for (const char c : formula.substr(0, at)) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
    ++column;
    if (c != '\n') continue;
    ++line;
    column = 1;
  }
  //: the place in a formula, then a sentence on it
  return Phrase::of("Line %1, column %2: %3", line, column, what);
}

/// The parsers of the lines and the variables that they are bound to.
struct FormulaEvaluator::Parsers {
  FormulaArguments at;
  std::vector<double> sizes;  ///< of the amplitudes
  std::vector<mu::Parser> ofLines;

  /// The value of a line; NaN if it is not a number or its size exceeds 10⁶.
  double evaluate(std::size_t line) {
    constexpr double largest = 1e6;
    try {
      const double value = ofLines[line].Eval();
      return std::abs(value) <= largest ? value : notANumber;
    } catch (const mu::ParserError&) {
      return notANumber;
    }
  }
};

FormulaEvaluator::FormulaEvaluator(const Formula& formula) : m_parsers(std::make_unique<Parsers>()) {
  m_parsers->sizes.assign(formula.amplitudes.size(), 0);
  const mu::Parser bare = bareParser();
  m_parsers->ofLines.assign(formula.lines.size(), bare);
  for (std::size_t line = 0; line < formula.lines.size(); ++line) {
    mu::Parser& parser = m_parsers->ofLines[line];
    for (const FormulaVariable& variable : formulaVariables)
      parser.DefineVar(std::string(variable.name), &(m_parsers->at.*variable.value));
    for (const std::size_t amplitude : formula.lines[line].amplitudes)
      parser.DefineVar(formula.amplitudes[amplitude].name, &m_parsers->sizes[amplitude]);
    parser.SetExpr(formula.lines[line].expression);
  }
}

FormulaEvaluator::FormulaEvaluator(FormulaEvaluator&&) noexcept = default;
FormulaEvaluator::~FormulaEvaluator() = default;

double FormulaEvaluator::value(std::size_t line, std::size_t amplitude, const FormulaArguments& at) const {
  m_parsers->at = at;
  m_parsers->sizes[amplitude] = 1;
  const double value = m_parsers->evaluate(line);
  m_parsers->sizes[amplitude] = 0;
  return value;
}

/// Is a line proportional to its amplitudes? Tests arguments spread over the range of readings.
class LinearityCheck {
 public:
  explicit LinearityCheck(const Formula& formula) : m_formula(formula), m_evaluator(formula) {}

  /// Absent if the line is proportional to its amplitudes; else the amplitude at fault. That amplitude is
  /// absent if the line has a part without amplitude, or a product of amplitudes.
  std::optional<std::optional<std::size_t>> bent(std::size_t line) {
    constexpr int places = 8;
    for (int place = 0; place < places; ++place) {
      m_evaluator.m_parsers->at = spread();
      const double none = with(line, {});
      if (none != 0 && std::isfinite(none)) return std::optional<std::size_t>();
      std::vector<std::pair<std::size_t, double>> all;
      double sum = 0;
      for (const std::size_t amplitude : m_formula.lines[line].amplitudes) {
        const double size = 1 + m_random.uniform(), once = with(line, {{amplitude, 1}});
        if (!isAlike(with(line, {{amplitude, -size}}), -size * once)) return amplitude;
        all.emplace_back(amplitude, size);
        sum += size * once;
      }
      if (!isAlike(with(line, all), sum)) return std::optional<std::size_t>();
    }
    return std::nullopt;
  }

 private:
  double with(std::size_t line, const std::vector<std::pair<std::size_t, double>>& sizes) {
    auto& parsers = *m_evaluator.m_parsers;
    std::ranges::fill(parsers.sizes, 0);
    for (const auto& [amplitude, size] : sizes) parsers.sizes[amplitude] = size;
    return parsers.evaluate(line);
  }

  /// Equal up to rounding? Also true if a value is not a number, since this does not prove a fault.
  static bool isAlike(double one, double other) {
    constexpr double rounding = 1e-9;
    return !(std::abs(one - other) > rounding * (1 + std::abs(one) + std::abs(other)));
  }

  double sign() { return m_random.uniform() < 0.5 ? -1 : 1; }
  FormulaArguments spread() {
    constexpr double wide = 6, near = 0.3;
    return {.s = 3 * sign() * m_random.uniform(),
            .t = m_random.uniform(),
            .a = near * sign() * m_random.uniform(),
            .e = near * sign() * m_random.uniform(),
            .horizontalCircle = wide * m_random.uniform(),
            .verticalCircle = wide * m_random.uniform(),
            .leg = sign(),
            .round = static_cast<double>(m_random.whole(1, 3)),
            .face = sign(),
            .position = sign()};
  }

  const Formula& m_formula;
  FormulaEvaluator m_evaluator;
  RandomSource m_random{1};
};

namespace {

/// Builds a formula from the statements of its text.
class FormulaMaker {
 public:
  explicit FormulaMaker(std::string_view text) : m_text(text) {}

  Result<Formula, FormulaFault> make() {
    if (m_text.size() > longestFormula)
      return FormulaFault{
          longestFormula, m_text.size() - longestFormula,
          Phrase::of("The formula is too long: it may have at most %1 characters.", longestFormula)};
    const auto statements = formulaStatements(m_text);
    if (!statements) return statements.problem();
    for (const FormulaStatement& statement : *statements)
      if (auto fault = carrierNamed(statement.name.name) ? std::nullopt : addNumber(statement))
        return *std::move(fault);
    for (const FormulaStatement& statement : *statements)
      if (const auto carrier = carrierNamed(statement.name.name))
        if (auto fault = addLine(statement, *carrier)) return *std::move(fault);
    if (m_formula.lines.empty())
      return FormulaFault{m_text.size(), 0,
                          Phrase::of("No line says what is displaced: add one such as radial = A*cos(2*s).")};
    if (auto fault = checkLinear()) return *std::move(fault);
    return std::move(m_formula);
  }

 private:
  std::string_view m_text;
  Formula m_formula;
  std::map<std::string_view, double> m_numbers;
  std::vector<FormulaStatement> m_statements;  ///< the statement of each line
  std::vector<std::vector<FormulaName>> m_names;

  static FormulaFault faultAt(const FormulaName& name, std::string what) {
    return {name.at, name.name.size(), std::move(what)};
  }

  std::optional<FormulaFault> addNumber(const FormulaStatement& statement) {
    const std::string_view name = statement.name.name;
    const auto isNamed = [&](const auto& entry) { return entry.name == name; };
    if (std::ranges::any_of(formulaVariables, isNamed) || std::ranges::any_of(formulaFunctions, isNamed) ||
        name == "pi" || name == "temperature" || m_numbers.contains(name))
      return faultAt(
          statement.name,
          Phrase::of(
              "%1 cannot be set: left of = must be the displaced quantity, such as radial, or a new name.",
              quotation(name)));
    auto plain = plainExpression(statement, m_numbers);
    if (!plain) return plain.problem();
    for (const auto* names : {&plain->variables, &plain->amplitudes})
      if (!names->empty())
        return faultAt(names->front(), Phrase::of("This line sets %1 to a number: remove %2.",
                                                  quotation(name), quotation(names->front().name)));
    Formula constant{.lines = {{.expression = plain->text, .amplitudes = {}}}, .amplitudes = {{"unused"}}};
    const double value = FormulaEvaluator(constant).value(0, 0, {});
    if (!std::isfinite(value))
      return FormulaFault{statement.at, statement.expression.size(), Phrase::of("This is no finite number.")};
    m_numbers[name] = value;
    return std::nullopt;
  }

  std::optional<FormulaFault> addLine(const FormulaStatement& statement, FormCarrier carrier) {
    auto plain = plainExpression(statement, m_numbers);
    if (!plain) return plain.problem();
    FormulaLine line{.carrier = carrier, .expression = plain->text, .amplitudes = {}};
    for (const FormulaName& variable : plain->variables) {
      const auto known = std::ranges::find(formulaVariables, variable.name, &FormulaVariable::name);
      line.actsOnZeros = line.actsOnZeros && known->isOfZerosToo;
      if (std::ranges::find(line.variables, known->value) == line.variables.end())
        line.variables.push_back(known->value);
    }
    for (const FormulaName& name : plain->amplitudes)
      if (auto fault = addAmplitude(name, line)) return fault;
    if (line.amplitudes.empty())
      return FormulaFault{statement.at, statement.expression.size(),
                          Phrase::of("The expression has no amplitude: multiply it by a letter such as A.")};
    m_formula.lines.push_back(std::move(line));
    m_statements.push_back(statement);
    m_names.push_back(plain->amplitudes);
    return std::nullopt;
  }

  std::optional<FormulaFault> addAmplitude(const FormulaName& name, FormulaLine& line) {
    auto& all = m_formula.amplitudes;
    auto known = std::ranges::find(all, name.name, &FormulaAmplitude::name);
    if (known == all.end()) {
      if (all.size() == mostOwnTerms)
        return faultAt(name, Phrase::of("%1 is one amplitude too many: there may be %2.",
                                        quotation(name.name), mostOwnTerms));
      all.push_back({std::string(name.name), line.carrier});
      known = all.end() - 1;
    } else if (unitOf(known->carrier) != unitOf(line.carrier) ||
               isOfCircles(known->carrier) != isOfCircles(line.carrier)) {
      return faultAt(
          name, Phrase::of("The line %2, which is of another kind, already uses %1: use another letter here.",
                           quotation(name.name), quotation(nameOf(known->carrier))));
    }
    const auto index = static_cast<std::size_t>(known - all.begin());
    if (std::ranges::find(line.amplitudes, index) == line.amplitudes.end()) line.amplitudes.push_back(index);
    return std::nullopt;
  }

  std::optional<FormulaFault> checkLinear() const {
    LinearityCheck check(m_formula);
    for (std::size_t line = 0; line < m_formula.lines.size(); ++line) {
      const auto bent = check.bent(line);
      if (!bent) continue;
      if (!*bent)
        return FormulaFault{
            m_statements[line].at, m_statements[line].expression.size(),
            Phrase::of("The line must be a sum of terms, each with exactly one amplitude as a factor.")};
      const auto& name = m_formula.amplitudes[**bent].name;
      return faultAt(*std::ranges::find(m_names[line], name, &FormulaName::name),
                     Phrase::of("The line is not in proportion to %1: multiply by it, or set it to a number, "
                                "such as %2 = 1.",
                                quotation(name), name));
    }
    return std::nullopt;
  }
};

}  // namespace

Result<Formula, FormulaFault> parseFormula(std::string_view text) {
  try {
    return FormulaMaker(text).make();
  } catch (const mu::ParserError&) {  // not expected: the parser accepts what was checked
    return FormulaFault{0, text.size(), Phrase::of("The formula cannot be read: write it more simply.")};
  }
}

}  // namespace alidade

#include "core/terms/formula_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::string_view degreeSigns[] = {"°", "º", "deg"};

bool startsName(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isInName(char c) {
  return startsName(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::size_t nameLength(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, isInName);
  return static_cast<std::size_t>(end - text.begin());
}

template <typename List>
auto* named(List& list, std::string_view name) {
  const auto found = std::ranges::find(list, name, [](const auto& entry) { return entry.name; });
  return found == std::end(list) ? nullptr : &*found;
}

/// Length of the first character, bytes.
std::size_t characterLength(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) ++length;
  return length;
}

/// Reads an expression from left to right.
class ExpressionReader {
 public:
  ExpressionReader(const FormulaStatement& statement, const std::map<std::string_view, double>& numbers)
      : m_text(statement.expression), m_at(statement.at), m_numbers(numbers) {}

  Result<PlainExpression, FormulaFault> read() {
    while (skipBlanks() && !m_fault) takeNext();
    if (!m_fault && m_wantsOperand)
      refuse(0, Phrase::of("The expression ends where a number or a name is missing."));
    if (!m_fault && !m_open.empty()) {
      m_next = m_open.back().at;
      refuse(1, Phrase::of("This parenthesis is not closed: add ) where it ends."));
    }
    if (m_fault) return *std::move(m_fault);
    return std::move(m_result);
  }

 private:
  /// An open parenthesis, and the function that it belongs to, if any.
  struct Open {
    std::size_t at;
    const FormulaFunction* function;
    int commas = 0;
  };

  bool skipBlanks() {
    while (m_next < m_text.size() && isBlank(m_text[m_next])) ++m_next;
    return m_next < m_text.size();
  }

  void refuse(std::size_t length, std::string what) {
    if (!m_fault) m_fault = FormulaFault{m_at + m_next, length, std::move(what)};
  }

  std::string_view rest() const { return m_text.substr(m_next); }

  void takeNext() {
    const char c = m_text[m_next];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return takeNumber();
    if (startsName(c)) return takeName();
    if (c == '(') return open(nullptr, 1);
    if (c == ')') return close();
    if (c == ',') return takeComma();
    for (const auto& [sign, plain] :
         {std::pair("+", '+'), std::pair("-", '-'), std::pair("−", '-'), std::pair("*", '*'),
          std::pair("·", '*'), std::pair("×", '*'), std::pair("/", '/'), std::pair("^", '^')})
      if (rest().starts_with(sign)) return takeOperator(plain, std::string_view(sign).size());
    const std::size_t length = characterLength(rest());
    for (const std::string_view sign : degreeSigns)
      if (rest().starts_with(sign))
        return refuse(length, Phrase::of("The sign ° is allowed only after a number, such as 83°."));
    refuse(length, Phrase::of("The sign %1 has no meaning in a formula: take it out.",
                              quotation(rest().substr(0, length))));
  }

  /// Must be called before a number, name or parenthesis. False, with a fault, if an operator is missing.
  bool beginOperand(std::size_t length) {
    if (m_wantsOperand) return true;
    refuse(length, Phrase::of("An operator such as * is missing before %1.",
                              quotation(rest().substr(0, std::max<std::size_t>(length, 1)))));
    return false;
  }

  void takeNumber() {
    double value = 0;
    const auto [end, error] = std::from_chars(m_text.data() + m_next, m_text.data() + m_text.size(), value);
    const auto length = static_cast<std::size_t>(end - (m_text.data() + m_next));
    constexpr double largest = 1e15;
    if (error != std::errc() || !(value <= largest))
      return refuse(
          std::max<std::size_t>(length, 1),
          Phrase::of("This is no valid number: type one up to 10^15, with a point as decimal sign."));
    if (!beginOperand(length)) return;
    m_next += length;
    const std::size_t behind = m_next;
    skipBlanks();
    bool isDegrees = false;
    for (const std::string_view sign : degreeSigns) {
      const bool isWord = startsName(sign.front());
      if (!rest().starts_with(sign) || (isWord && nameLength(rest()) != sign.size())) continue;
      m_next += sign.size();
      isDegrees = true;
      break;
    }
    if (!isDegrees) m_next = behind;
    addValue(isDegrees ? value * std::numbers::pi / 180 : value);
  }

  void addValue(double value) {
    m_result.text += "(" + shortestText(value) + ")";
    m_wantsOperand = false;
  }

  void takeName() {
    const std::size_t length = nameLength(rest());
    const std::string_view name = rest().substr(0, length);
    if (!beginOperand(length)) return;
    if (isCall(length)) {
      const FormulaFunction* function = named(formulaFunctions, name);
      if (!function)
        return refuse(
            length,
            Phrase::of("%1 is not a known function: use bump, step, hinge, exponential, sin, cos, tan, asin, "
                       "acos, atan, atan2, sinh, cosh, tanh, exp, ln, sqrt, abs, sign, min or max.",
                       quotation(name)));
      m_result.text += name;
      m_next += length;
      skipBlanks();
      return open(function, 1);
    }
    if (!addName(name)) return;
    m_next += length;
    m_wantsOperand = false;
  }

  bool isCall(std::size_t length) const {
    std::size_t behind = m_next + length;
    while (behind < m_text.size() && isBlank(m_text[behind])) ++behind;
    return behind < m_text.size() && m_text[behind] == '(';
  }

  /// Adds a name that is not a function call. False, with a fault, if the name is not allowed.
  bool addName(std::string_view name) {
    constexpr std::size_t longestName = 20;
    const FormulaName found{name, m_at + m_next};
    if (const auto number = m_numbers.find(name); number != m_numbers.end()) {
      addValue(number->second);
    } else if (name == "pi") {
      addValue(std::numbers::pi);
    } else if (named(formulaVariables, name)) {
      m_result.variables.push_back(found);
      m_result.text += name;
    } else if (name == "temperature") {
      refuse(name.size(), Phrase::of("The readings have no temperature of their own: take another variable, "
                                     "such as t, the elapsed share of the session."));
    } else if (carrierNamed(name) || named(formulaFunctions, name)) {
      refuse(name.size(), Phrase::of("%1 cannot be an amplitude, as it has another meaning: take a letter "
                                     "such as A.",
                                     quotation(name)));
    } else if (name.size() > longestName) {
      refuse(name.size(), Phrase::of("The name is too long: take one of at most %1 letters.", longestName));
    } else {
      m_result.amplitudes.push_back(found);
      m_result.text += name;
    }
    return !m_fault;
  }

  void open(const FormulaFunction* function, std::size_t length) {
    constexpr std::size_t deepest = 40;
    if (!function && !beginOperand(length)) return;
    if (m_open.size() == deepest)
      return refuse(length, Phrase::of("There are too many parentheses inside one another."));
    m_open.push_back({m_next, function});
    m_result.text += '(';
    m_next += length;
    m_wantsOperand = true;
  }

  void close() {
    if (m_open.empty()) return refuse(1, Phrase::of("No parenthesis is open here: take ) out."));
    if (m_wantsOperand) return refuse(1, Phrase::of("A number or a name is missing before )."));
    if (const auto [at, function, commas] = m_open.back(); function && commas + 1 != function->arguments)
      return refuse(1, countFault(*function));
    m_open.pop_back();
    m_result.text += ')';
    ++m_next;
  }

  static std::string countFault(const FormulaFunction& function) {
    constexpr const char* usage[] = {
        PHRASE_LATER("Phrase", "%1 takes one argument: write %1(x)."),
        PHRASE_LATER("Phrase", "%1 takes two arguments: write %1(x, y)."),
        PHRASE_LATER("Phrase", "%1 takes three arguments: write %1(x, at, width).")};
    return Phrase::of(usage[function.arguments - 1], std::string(function.name));
  }

  void takeComma() {
    if (m_open.empty() || !m_open.back().function)
      return refuse(1, Phrase::of("A comma is allowed only between the arguments of a function. In numbers, "
                                  "type a decimal point."));
    if (m_wantsOperand) return refuse(1, Phrase::of("A number or a name is missing before the comma."));
    if (++m_open.back().commas >= m_open.back().function->arguments)
      return refuse(1, countFault(*m_open.back().function));
    m_result.text += ',';
    ++m_next;
    m_wantsOperand = true;
  }

  void takeOperator(char plain, std::size_t length) {
    const bool isSign = m_wantsOperand && (plain == '+' || plain == '-');
    if (m_wantsOperand && (!isSign || m_signs > 0))
      return refuse(length, Phrase::of("A number or a name is missing before %1.",
                                       quotation(rest().substr(0, length))));
    m_signs = isSign ? 1 : 0;
    if (isSign && plain == '-' && !m_result.text.empty() && m_result.text.back() == '^')
      return refuse(length, Phrase::of("Put a negative exponent in parentheses, such as x^(-1)."));
    if (!isSign || plain == '-') m_result.text += plain;
    m_next += length;
    m_wantsOperand = true;
  }

  std::string_view m_text;
  std::size_t m_at, m_next = 0;
  const std::map<std::string_view, double>& m_numbers;
  PlainExpression m_result;
  std::vector<Open> m_open;
  bool m_wantsOperand = true;
  int m_signs = 0;
  std::optional<FormulaFault> m_fault;
};

}  // namespace

Result<std::vector<FormulaStatement>, FormulaFault> formulaStatements(std::string_view text) {
  std::vector<FormulaStatement> statements;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(";\n", begin), text.size());
    std::size_t first = begin;
    while (first < end && isBlank(text[first])) ++first;
    const std::string_view line = text.substr(first, end - first);
    begin = end + 1;
    if (line.empty()) continue;
    const std::size_t length = nameLength(line);
    std::size_t equals = length;
    while (equals < line.size() && isBlank(line[equals])) ++equals;
    if (length == 0 || !startsName(line.front()) || equals >= line.size() || line[equals] != '=')
      return FormulaFault{first, std::max(length, characterLength(line)),
                          Phrase::of("A line begins with what it displaces, such as radial = A*cos(2*s).")};
    while (++equals < line.size() && isBlank(line[equals])) {
    }
    const std::string_view expression = line.substr(equals);
    if (const std::size_t second = expression.find('='); second != std::string_view::npos)
      return FormulaFault{
          first + equals + second, 1,
          Phrase::of("A line has only one =: begin a new line, or put a semicolon before it.")};
    statements.push_back({{line.substr(0, length), first}, expression, first + equals});
  }
  return statements;
}

Result<PlainExpression, FormulaFault> plainExpression(const FormulaStatement& statement,
                                                      const std::map<std::string_view, double>& numbers) {
  return ExpressionReader(statement, numbers).read();
}

}  // namespace alidade

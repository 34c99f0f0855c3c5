#include "core/terms/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

namespace alidade {
namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

Formula sound(const std::string& text) {
  const auto formula = parseFormula(text);
  EXPECT_TRUE(formula) << text << ": " << formula.problem().text(text);
  return formula ? *formula : Formula();
}

double valueOf(const std::string& text, const FormulaArguments& at, std::size_t amplitude = 0,
               std::size_t line = 0) {
  return FormulaEvaluator(sound(text)).value(line, amplitude, at);
}

TEST(Formula, HasLinesWithTheirAmplitudes) {
  const Formula formula =
      sound("horizontal = A*cos(2*pi*t) + B*sin(2*pi*t)\n vertical = C*t^2; radial = R*s");
  ASSERT_EQ(formula.lines.size(), 3u);
  EXPECT_EQ(formula.lines[0].carrier, FormCarrier::Horizontal);
  EXPECT_EQ(formula.lines[0].amplitudes, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(formula.lines[1].amplitudes, (std::vector<std::size_t>{2}));
  ASSERT_EQ(formula.amplitudes.size(), 4u);
  EXPECT_EQ(formula.amplitudes[3].name, "R");
  EXPECT_TRUE(formula.lines[0].actsOnZeros) << "a zero has its moment";
  EXPECT_FALSE(formula.lines[2].actsOnZeros) << "a zero has no place of the slider";
}

// By the definitions of the functions; rounding of one or two operations.
TEST(Formula, IsWhatItsFunctionsAre) {
  const FormulaArguments at{.s = 85 * degree,
                            .t = 0.25,
                            .a = 0.1,
                            .e = -0.05,
                            .horizontalCircle = 2,
                            .verticalCircle = 1.5,
                            .leg = -1,
                            .round = 2,
                            .face = -1,
                            .position = -1};
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(valueOf("radial = A*bump(s, 83°, w); w = 4°", at), std::exp(-0.125), rounding);
  EXPECT_NEAR(valueOf("radial = A*bump(s, 83 deg, 4deg)", at), std::exp(-0.125), rounding);
  EXPECT_EQ(valueOf("radial = A*step(s, 83°)", at), 1);
  EXPECT_NEAR(valueOf("radial = A*hinge(s, 83°)/10°", at), 0.2, rounding);
  EXPECT_NEAR(valueOf("orientation = A*exponential(t, 0.5)", at), std::exp(-0.5), rounding);
  EXPECT_NEAR(valueOf("vertical = k*tan(e)^2", at), std::pow(std::tan(0.05), 2), rounding);
  EXPECT_NEAR(valueOf("radial = A*cos(7*s) + B*sin(7*s)", at, 1), std::sin(7 * 85 * degree), rounding);
  EXPECT_EQ(valueOf("horizontal = k*leg", at), -1);
  EXPECT_NEAR(valueOf("horizontal = k*face*(alpha - beta)*round*position", at), 1, rounding);
  EXPECT_NEAR(valueOf("across = −A·max(0, s − 80°)", at), -5 * degree, rounding) << "typographic signs";
  EXPECT_NEAR(valueOf("x = 2*-A*min(a, e)", at), 0.1, rounding);
  EXPECT_NEAR(valueOf("slider = A*-s^2", at), -std::pow(85 * degree, 2), rounding) << "the sign comes last";
}

TEST(Formula, HasNoValueWhereThereIsNone) {
  EXPECT_TRUE(std::isnan(valueOf("radial = A*sqrt(s - 10)", {})));
  EXPECT_TRUE(std::isnan(valueOf("radial = A/s", {})));
  EXPECT_TRUE(std::isnan(valueOf("radial = A*exp(100*(1 + t))", {}))) << "beyond any reading";
}

struct Faulty {
  const char* text;
  const char* marked;  ///< what the fault marks
  const char* what;
};

class FaultyFormula : public testing::TestWithParam<Faulty> {};

TEST_P(FaultyFormula, IsMarkedWhereItIsWrong) {
  const std::string text = GetParam().text;
  const auto formula = parseFormula(text);
  ASSERT_FALSE(formula);
  const FormulaFault& fault = formula.problem();
  ASSERT_LE(fault.at + fault.length, text.size());
  EXPECT_EQ(text.substr(fault.at, fault.length), GetParam().marked);
  EXPECT_THAT(fault.what, HasSubstr(GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    All, FaultyFormula,
    testing::Values(
        Faulty{"", "", "No line says what is displaced"}, Faulty{"w = 4°", "", "No line"},
        Faulty{"radial", "radial", "A line begins with what it displaces"},
        Faulty{"radial = A*foo(s)", "foo", "is not a known function"},
        Faulty{"radial = A*bump(s, 83°)", ")", "takes three arguments"},
        Faulty{"radial = A*sin(s, s)", ",", "takes one argument"},
        Faulty{"radial = A*(s + 1", "(", "not closed"},
        Faulty{"radial = A*s)", ")", "No parenthesis is open"}, Faulty{"radial = A*", "", "ends where"},
        Faulty{"radial = A**s", "*", "missing before"}, Faulty{"radial = 2 A", "A", "operator"},
        Faulty{"radial = A*s°", "°", "after a number"}, Faulty{"radial = A*s#2", "#", "has no meaning"},
        Faulty{"radial = A*s = 2", "=", "only one ="}, Faulty{"radial = A*\"rm\"", "\"", "has no meaning"},
        Faulty{"radial = A*(s, 2)", ",", "comma is allowed only"},
        Faulty{"radial = A*temperature", "temperature", "no temperature"},
        Faulty{"radial = A*x", "x", "another meaning"}, Faulty{"radial = A*s; s = 4", "s", "cannot be set"},
        Faulty{"radial = A*s*w; w = A", "A", "This line sets"},
        Faulty{"radial = A*w; w = 1/0", "1/0", "no finite number"},
        Faulty{"radial = cos(2*s)", "cos(2*s)", "has no amplitude"},
        Faulty{"radial = A^2*s", "A", "not in proportion to"},
        Faulty{"radial = bump(s, 83°, w)", "w", "not in proportion to"},
        Faulty{"radial = A*s + 1", "A*s + 1", "exactly one amplitude"},
        Faulty{"radial = A*s + A*B*s", "A*s + A*B*s", "exactly one amplitude"},
        Faulty{"radial = A*s; horizontal = A*t", "A", "of another kind"},
        Faulty{"radial = A+B+C+D+E+F+G", "G", "too many"},
        Faulty{"radial = A*2^-1", "-", "negative exponent"},
        Faulty{"radial = A*1e999", "1e999", "no valid number"}));

TEST(Formula, TellsLineAndColumnInCharacters) {
  const std::string text = "radial = A*bump(s, 83°, 4°)\nacross = B*bump(s, 83°, 4°)*foo(s)";
  const auto formula = parseFormula(text);
  ASSERT_FALSE(formula);
  EXPECT_THAT(formula.problem().text(text), HasSubstr("Line 2, column 29: “foo”"));
}

// Formulas from unknown authors are refused or bounded in time. The limit is far above the time needed, since
// the machine may be busy.
TEST(Formula, OfStrangersIsBounded) {
  std::string deep = "radial = A", chain = "radial = A", powers = "radial = A*9";
  for (int i = 0; i < 60; ++i) deep = "radial = (" + deep.substr(9) + ")";
  while (chain.size() < longestFormula - 10) chain += "+A*sin(s)";
  while (powers.size() < longestFormula - 2) powers += "^9";
  const std::string hostile[] = {deep,
                                 chain,
                                 powers,
                                 std::string(400, '('),
                                 std::string(5000, 'A'),
                                 "radial = A*s\xff\xfe",
                                 std::string("radial = A\0*s", 13),
                                 "radial = A*(s>1?2:3)",
                                 "radial = A*_pi",
                                 "radial = A*rnd(1)"};
  for (const std::string& text : hostile) {
    const auto start = std::chrono::steady_clock::now();
    const auto formula = parseFormula(text);
    const std::size_t lines = formula ? formula->lines.size() : 0;
    for (std::size_t line = 0; line < lines; ++line)
      EXPECT_FALSE(std::isinf(FormulaEvaluator(*formula).value(line, 0, {.s = 1}))) << text;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500)) << text;
  }
}

}  // namespace
}  // namespace alidade

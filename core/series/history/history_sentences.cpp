#include "core/series/history/history_sentences.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/wording/effect_name.h"
#include "core/wording/series_words.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

std::string superscript(int number) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += digits[c - '0'];
  return text;
}

double leastU(const History& history) {
  double least = std::numeric_limits<double>::infinity();
  for (const DatedValue& value : history.values) least = std::min(least, value.apart);
  return least;
}

std::string chanceText(double chance) {
  return chance < 0.0005 ? Phrase::of("p < 0.001") : Phrase::of("p = %1", displayText(chance, 3));
}

/// Do the means of two dates differ by more than their U? Their values may all the same agree by χ².
bool areDatesApart(const History& history) {
  return history.twoDates && std::abs(history.twoDates->value) > history.twoDates->expanded;
}

std::string agreement(const History& history) {
  if (!history.chance) return Phrase::of("There is only one value: it cannot be compared.");
  const std::string chi =
      history.degreesOfFreedom == 1
          ? Phrase::of("χ² = %1 with one degree of freedom, %2", displayText(history.chiSquare, 2),
                       chanceText(*history.chance))
          : Phrase::of("χ² = %1 with %2 degrees of freedom, %3", displayText(history.chiSquare, 2),
                       history.degreesOfFreedom, chanceText(*history.chance));
  if (*history.chance >= leastChance && history.course != Course::Constant)
    return Phrase::of(
        "%1: the values agree within their uncertainties, yet their course over time shows a change.", chi);
  if (*history.chance >= leastChance && areDatesApart(history))
    return Phrase::of("%1: the values scatter about one mean as their uncertainties say.", chi);
  if (*history.chance >= leastChance)
    return Phrase::of("%1: the values agree within their uncertainties.", chi);
  return Phrase::of("%1: the values scatter about one mean %2 times as much as their uncertainties say.", chi,
                    displayText(history.birgeRatio, 1));
}

std::string stepSentence(const History& history, const HistoryStep& step, const HistoryNumbers& numbers) {
  const std::string size = numbers.withUncertainty(std::abs(step.size), step.expanded);
  const std::string sized = step.size > 0
                                ? Phrase::of("From %1 on the value is larger by %2.", step.date, size)
                                : Phrase::of("From %1 on the value is smaller by %2.", step.date, size);
  if (step.earliest == step.latest)
    return Phrase::of("%1 The change happened between %2 and %3.", sized, history.values[step.first - 1].date,
                      step.date);
  return Phrase::of("%1 The first value after the change is one of those from %2 to %3 (95 %).", sized,
                    history.values[step.earliest].date, history.values[step.latest].date);
}

/// Why the values scatter, if no change explains it; empty if they do not.
std::string scatterSentence(const History& history, const HistoryNumbers& numbers) {
  const bool isLarge = history.chance && *history.chance < leastChance;
  if (!isLarge && !areDatesApart(history)) return {};
  if (history.twoDates)
    return Phrase::of(
        "The values of %1 and %2 differ by %3: measure on a third date to tell a change from understated "
        "uncertainties.",
        history.values.front().date, history.values.back().date,
        numbers.withUncertainty(std::abs(history.twoDates->value), history.twoDates->expanded));
  if (history.courses.empty())
    return Phrase::of(
        "All values are of one date: measure on other dates to tell a change from understated "
        "uncertainties.");
  return Phrase::of(
      "Neither a step nor a trend explains this scatter: the uncertainties are understated, or "
      "the values are too few to show what changed.");
}

std::vector<std::string> courseSentences(const History& history, const HistoryNumbers& numbers) {
  std::vector<std::string> sentences;
  switch (history.course) {
    case Course::Constant:
      if (std::string sentence = scatterSentence(history, numbers); !sentence.empty())
        sentences.push_back(std::move(sentence));
      break;
    case Course::Steps:
      for (const HistoryStep& step : history.steps) sentences.push_back(stepSentence(history, step, numbers));
      if (std::ranges::any_of(history.steps, [](const HistoryStep& step) {
            return step.valuesBefore == 1 || step.valuesAfter == 1;
          }))
        sentences.push_back(Phrase::of(
            "A level with only one value may be an outlier: measure once more before acting on it."));
      break;
    case Course::Trend:
      sentences.push_back(Phrase::of("The value changes steadily, by %1.",
                                     numbers.ratePerYear(history.trend->perYear, history.trend->expanded)));
      break;
    case Course::OddValue:
      sentences.push_back(
          Phrase::of("The value of %1 is an outlier: look for what was different that day, such as a misread "
                     "value or another set-up, before assuming a change.",
                     history.values[*history.oddValue].date));
      break;
    case Course::Wander:
      sentences.push_back(
          Phrase::of("The values wander: values close in time agree better than distant ones, and neither "
                     "steps nor a trend explain the values equally well."));
      break;
  }
  return sentences;
}

/// The courses with a probability of at least 1 %, the most probable first.
std::string rivals(const History& history) {
  constexpr double least = 0.01;
  std::vector<std::string> texts;
  for (const CourseProbability& course : history.courses)
    if (course.probability >= least)
      texts.push_back(
          Phrase::of("%1 %2", courseName(course.course), shortProbabilityText(course.probability)));
  return listed(texts);
}

/// States whether the values after the baseline are within their limits.
std::string watchSentence(const History& history, const HistoryNumbers& numbers) {
  const ControlChart& chart = history.chart;
  const auto& values = history.values;
  const std::string baseline =
      chart.baseline == 1
          ? Phrase::of("Baseline: the value of %1, %2.", values.front().date, numbers.withUnit(chart.centre))
          : Phrase::of("Baseline: %1 values from %2 to %3, centre line %4.", chart.baseline,
                       values.front().date, values[chart.baseline - 1].date,
                       numbers.withUncertainty(chart.centre, history.factor * chart.centreU));
  const auto watched = chart.points.begin() + static_cast<std::ptrdiff_t>(chart.baseline);
  const auto out = std::find_if(watched, chart.points.end(), [](const auto& point) { return point.isOut; });
  const auto drifted =
      std::find_if(watched, chart.points.end(), [](const auto& point) { return point.isEwmaOut; });
  const std::size_t count = values.size() - chart.baseline;
  const auto dateOf = [&](auto point) {
    return values[static_cast<std::size_t>(point - chart.points.begin())].date;
  };
  const auto outside =
      std::count_if(watched, chart.points.end(), [](const auto& point) { return point.isOut; });
  if (outside > 0)
    return Phrase::of("%1 Later values outside their limits: %2 of %3, the first on %4.", baseline, outside,
                      count, dateOf(out));
  if (drifted != chart.points.end())
    return Phrase::of(
        "%1 Later values outside their limits: 0 of %2, but their average (EWMA) leaves its limits on %3.",
        baseline, count, dateOf(drifted));
  return Phrase::of("%1 Later values outside their limits: 0 of %2.", baseline, count);
}

std::string whenAndWhat(const Epoch& epoch) {
  return Phrase::of("%1 (%2)", epoch.date.empty() ? "—" : epoch.date, quotation(epoch.title));
}

}  // namespace

HistoryNumbers::HistoryNumbers(const History& history, std::string unit) : m_unit(std::move(unit)) {
  double largest = 0;
  for (const DatedValue& value : history.values) largest = std::max(largest, std::abs(value.value));
  const double least = history.factor * leastU(history);
  // Numbers between these limits are readable without a power of ten.
  constexpr double tooSmall = 1e-6, tooLarge = 1e7;
  if (largest >= tooLarge || (least < tooSmall && largest < 1))
    m_power = static_cast<int>(std::floor(std::log10(largest > 0 ? largest : least)));
  m_decimals = decimalsFor(least * scale());
  if (m_power != 0) m_unit = "10" + superscript(m_power) + (m_unit.empty() ? "" : " " + m_unit);
}

std::string HistoryNumbers::number(double value) const {
  return displayText(value * scale(), m_decimals);
}

std::string HistoryNumbers::withUnit(double value, int decimals, const std::string& suffix) const {
  std::string text = displayText(value * scale(), decimals);
  const std::string unit = m_unit + suffix;
  if (unit.empty()) return text;
  return text + (m_power != 0 ? " × " : " ") + unit;
}

std::string HistoryNumbers::withUnit(double value) const {
  return withUnit(value, m_decimals, "");
}

std::string HistoryNumbers::exact(double value) const {
  const std::string text = displayShortest(value * scale());
  return m_unit.empty() ? text : text + (m_power != 0 ? " × " : " ") + m_unit;
}

std::string HistoryNumbers::withUncertainty(double value, double expanded) const {
  const int decimals = std::max(m_decimals, decimalsFor(expanded * scale(), m_decimals));
  return withUnit(value, decimals, "") + " ± " + withUnit(expanded, decimals, "");
}

std::string HistoryNumbers::ratePerYear(double value, double expanded) const {
  const int decimals = decimalsFor(expanded * scale(), m_decimals);
  const std::string suffix = m_unit.empty() ? "1/a" : "/a";
  return withUnit(value, decimals, suffix) + " ± " + withUnit(expanded, decimals, suffix);
}

double HistoryNumbers::scale() const {
  return std::pow(10.0, -m_power);
}

std::string HistoryNumbers::heading() const {
  return m_unit;
}

std::string plusMinusText(const History& history) {
  return Phrase::of("expanded uncertainty, %1", shortProbabilityText(history.coverage));
}

std::vector<std::string> historySentences(const History& history, const std::string& unit) {
  const HistoryNumbers numbers(history, unit);
  std::vector<std::string> sentences;
  if (history.chart.baseline < history.values.size()) sentences.push_back(watchSentence(history, numbers));
  const std::string mean = numbers.withUncertainty(history.mean.value, history.mean.expanded);
  sentences.push_back(history.values.size() == 1
                          ? Phrase::of("Value: %1 (%2).", mean, plusMinusText(history))
                          : Phrase::of("Weighted mean of %1 values: %2 (%3).", history.values.size(), mean,
                                       plusMinusText(history)));
  sentences.push_back(agreement(history));
  for (std::string& sentence : courseSentences(history, numbers)) sentences.push_back(std::move(sentence));
  if (history.degreesOfFreedom > 0 && history.scatter > 1 && history.chance &&
      *history.chance < leastChance) {
    if (history.course == Course::Constant)
      sentences.push_back(Phrase::of("From the observed scatter, the expanded uncertainty of the mean is %1.",
                                     numbers.withUnit(history.mean.scatteredExpanded)));
  }
  if (const std::string others = rivals(history); !others.empty())
    sentences.push_back(Phrase::of("Probability of each explanation of the values: %1.", others));
  return sentences;
}

namespace {

std::string sharedErrors(const DeviceHistory& device) {
  if (device.epochs.size() < 2) return Phrase::of("There is one session: it cannot be compared.");
  if (device.serial.empty())
    return Phrase::of(
        "The sessions state no serial number of the device. No errors are therefore assumed to be common to "
        "them, and only larger changes are detected. Enter the number to detect smaller ones.");
  if (device.hasOneInstrument)
    return Phrase::of(
        "All sessions have the same device and instrument. Their errors change Δd by the same amount each "
        "time: this amount is in U and in the mean, but not in the expected scatter.");
  return Phrase::of(
      "The sessions were not all taken with the same instrument, or do not state its serial number: "
      "instrument errors are assumed to change Δd differently in each session.");
}

}  // namespace

std::string sharedSentence(const DeviceHistory& device) {
  std::string text = sharedErrors(device);
  if (device.hasBothCircles) text += " " + bothCirclesSentence();
  return text;
}

std::vector<std::string> congruenceSentences(const std::vector<Epoch>& epochs, const Congruence& congruence) {
  const std::string first = whenAndWhat(epochs[congruence.first]),
                    second = whenAndWhat(epochs[congruence.second]);
  const int decimals = decimalsFor(congruence.expanded);
  const std::string difference = lengthWithUncertainty(congruence.difference, congruence.expanded, decimals);
  std::vector<std::string> sentences;
  sentences.push_back(
      congruence.hasChanged
          ? Phrase::of("Δd has changed between %1 and %2 by %3, %4.", first, second, difference,
                       chanceText(congruence.chance))
          : Phrase::of("No change of Δd is detectable between %1 and %2: the difference is %3, %4.", first,
                       second, difference, chanceText(congruence.chance)));
  const auto addTest = [&](const CongruenceTest& test, const std::string& agree, const std::string& differ) {
    sentences.push_back(Phrase::of("%1 (T = %2 from %3 quantities, %4)",
                                   test.chance >= leastChance ? agree : differ,
                                   displayText(test.statistic, 1), test.ids.size(), chanceText(test.chance)));
  };
  if (congruence.device)
    addTest(
        *congruence.device,
        Phrase::of("From the readings alone, the device shows no change: (O1 − O2)/2 and the radii agree."),
        Phrase::of("From the readings alone, the device shows a change: (O1 − O2)/2 or the radii differ."));
  if (congruence.setUp)
    addTest(
        *congruence.setUp, Phrase::of("O1 and O2 have not moved relative to the theodolite."),
        Phrase::of("O1 and O2 have moved relative to the theodolite, as they do after every new set-up."));
  return sentences;
}

std::string quantityName(const std::string& id) {
  if (id == "intersection") return Phrase::of("Δd, measured");
  if (id == "intersection_of_fit") return Phrase::of("Δd, fit only");
  if (id == "o1_x") return Phrase::of("O1, x");
  if (id == "o1_y") return Phrase::of("O1, y");
  if (id == "o2_x") return Phrase::of("O2, x");
  if (id == "o2_y") return Phrase::of("O2, y");
  if (id == "radius_0") return Phrase::of("radius at 0°");
  if (id == "radius_180") return Phrase::of("radius at 180°");
  if (id == "line_of_sight") return Phrase::of("offset of the line of sight");
  const std::size_t colon = id.find(": ");
  if (colon == std::string::npos) return causeName(id);
  return Phrase::of("%1: %2", causeName(id.substr(0, colon)), parameterName(id.substr(colon + 2)));
}

std::string courseName(Course course) {
  switch (course) {
    case Course::Constant:
      return Phrase::of("constant");
    case Course::Steps:
      return Phrase::of("in steps");
    case Course::Trend:
      return Phrase::of("a trend");
    case Course::OddValue:
      return Phrase::of("one outlier");
    case Course::Wander:
      return Phrase::of("wandering");
  }
  return "";
}

std::string undatedSentence(const std::string& title) {
  return Phrase::of("%1 has no date and is not used: enter the day of the measurement", quotation(title));
}

}  // namespace alidade

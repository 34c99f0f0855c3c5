#include "core/diagnosis/forms/form_families.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double narrowest = 0.02, widest = 0.35;  // width of a bump, as a share of its argument's range
constexpr double quickest = 0.02, slowest = 1;     // time constant, as a share of the session
constexpr double fewestCycles = 0.5, mostCycles = 8;

/// The values that an argument takes, and how densely a grid covers them.
struct Range {
  double low = 0, high = 0;
  int steps = 0;

  double length() const { return high - low; }
  double at(double share) const { return low + share * length(); }
};

class FamilyMaker {
 public:
  explicit FamilyMaker(const FormReadings& readings) : m_readings(readings) {}

  std::vector<FormFamily> make() {
    for (const FormCarrier carrier : {Radial, Across, Slider}) addGuideway(carrier);
    for (const FormCarrier carrier : {X, Y, Z}) addRoom(carrier);
    for (const FormCarrier carrier : {Horizontal, Vertical}) addCircle(carrier);
    for (const FormCarrier carrier : {Orientation, Horizontal, Vertical}) addCourse(carrier);
    double sum = 0;
    for (const FormFamily& family : m_families) sum += std::exp(family.logPrior);
    for (FormFamily& family : m_families) family.logPrior -= std::log(sum);
    return std::move(m_families);
  }

 private:
  using enum FormCarrier;
  using enum FormFunction;
  using enum FormArgument;

  const FormReadings& m_readings;
  std::vector<FormFamily> m_families;

  void addGuideway(FormCarrier carrier) {
    constexpr int dense = 32;
    addHarmonics({.carrier = carrier, .of = S}, 12);
    addPlaces({.carrier = carrier, .of = S}, dense);
    if (carrier == Slider) addPowers({.carrier = carrier, .of = S}, 3);
    addPerPlace({.carrier = carrier, .function = PerPlace, .of = S});
    add({.carrier = carrier, .function = Hysteresis, .of = Leg});
    add({.carrier = carrier, .function = Hysteresis, .of = Position});
  }

  void addRoom(FormCarrier carrier) {
    addHarmonics({.carrier = carrier, .of = S}, 4);
    addCourse(carrier);
    add({.carrier = carrier, .function = Hysteresis, .of = Leg});
    add({.carrier = carrier, .function = Hysteresis, .of = Position});
  }

  void addCircle(FormCarrier carrier) {
    constexpr int sparse = 16, orders = 24, fewOrders = 4;
    const bool isVertical = carrier == Vertical;
    addHarmonics({.carrier = carrier,
                  .of = isVertical ? VerticalCircle : HorizontalCircle,
                  .turnsWithFace = isVertical},
                 orders);
    for (const FormArgument of : {Azimuth, Elevation})
      for (const bool turns : {false, true}) {
        const Form form{.carrier = carrier, .of = of, .turnsWithFace = turns};
        addPlaces(form, sparse);
        addPowers(form, 3);
        if (m_readings.has(form))
          addHarmonics(form, rangeOf(form, 0).length() > std::numbers::pi ? orders : fewOrders);
      }
    add({.carrier = carrier, .function = Hysteresis, .of = Face});
    add({.carrier = carrier, .function = Hysteresis, .of = Leg});
    add({.carrier = carrier, .function = Hysteresis, .of = Leg, .turnsWithFace = true});
  }

  /// Adds forms of time.
  void addCourse(FormCarrier carrier) {
    constexpr int moments = 20, constants = 10;
    constexpr double cycles = 0.5;
    const Form form{.carrier = carrier, .of = T};
    std::vector<double> numbers;
    for (int i = 0; i < constants; ++i)
      numbers.push_back(quickest * std::pow(slowest / quickest, i / (constants - 1.0)));
    addGrid(with(form, Exponential), numbers, std::log(slowest / quickest));
    numbers.clear();
    for (double each = fewestCycles; each <= mostCycles; each += cycles) numbers.push_back(each);
    addGrid(with(form, Harmonic), numbers, mostCycles - fewestCycles);
    addEdges(form, moments);
    addPowers(form, 2);
    add(with(form, Walk));
    addRounds({.carrier = carrier, .function = Step, .of = Round});
  }

  /// Adds steps between the rounds.
  void addRounds(const Form& form) {
    if (!m_readings.has(form)) return;
    const double last = m_readings.of(Round).maxCoeff();
    constexpr double most = 6;
    std::vector<double> between;
    for (double round = 1; round < std::min(last, most); ++round) between.push_back(round + 0.5);
    addGrid(form, between, last - 1);
  }

  /// Adds a form with one amplitude for each place, if the places are sighted often enough.
  void addPerPlace(const Form& form) {
    constexpr std::size_t most = 40;
    if (!m_readings.has(form)) return;
    const std::size_t places = placesOf(m_readings, form).size();
    const auto readings = static_cast<std::size_t>((m_readings.of(form.carrier).array() != 0).count());
    if (places <= most && readings >= 3 * places) add(form);
  }

  static Form with(Form form, FormFunction function) {
    form.function = function;
    return form;
  }

  /// The prior falls by two bits for each word of the form (`wordsOf`), and is divided by the order k.
  void add(const Form& form, std::vector<Form> grid = {}, double logVolume = 0) {
    if (!m_readings.has(form)) return;
    const bool hasOneFace = m_readings.face.maxCoeff() == m_readings.face.minCoeff();
    if (form.turnsWithFace && form.of != VerticalCircle && hasOneFace) return;
    const double ofOrder = form.order > 1 ? std::log(form.order) : 0;
    if (grid.empty()) grid.push_back(form);
    m_families.push_back(
        {form, std::move(grid), -wordsOf(form) * 2 * std::numbers::ln2 - ofOrder, logVolume});
  }

  void addGrid(const Form& form, std::span<const double> numbers, double volume) {
    std::vector<Form> grid;
    for (const double number : numbers) {
      grid.push_back(form);
      grid.back().numbers[0] = number;
    }
    if (!grid.empty()) add(form, std::move(grid), std::log(volume));
  }

  void addHarmonics(Form form, int most) {
    form.function = Harmonic;
    for (form.order = 1; form.order <= most; ++form.order) add(form);
  }

  void addPowers(Form form, int most) {
    form.function = Power;
    for (form.order = 1; form.order <= most; ++form.order) add(form);
  }

  Range rangeOf(const Form& form, int steps) const {
    const VectorXd& values = m_readings.of(form.of);
    Range range{values.maxCoeff(), values.minCoeff(), steps};
    for (Index i = 0; i < values.size(); ++i) {
      if (m_readings.of(form.carrier)[i] == 0) continue;
      range.low = std::min(range.low, values[i]);
      range.high = std::max(range.high, values[i]);
    }
    return range;
  }

  void addPlaces(const Form& form, int steps) {
    if (!m_readings.has(form)) return;
    const Range range = rangeOf(form, steps);
    if (!(range.length() > 0)) return;
    const Form bump = with(form, Bump);
    std::vector<Form> grid;
    constexpr int dense = 20;
    const std::vector<double> widths =
        steps > dense ? std::vector{0.025, 0.045, 0.08, 0.14, 0.25} : std::vector{0.05, 0.1, 0.2};
    for (const double width : widths)
      for (int i = 0; i <= steps; ++i) {
        grid.push_back(bump);
        grid.back().numbers = {range.at(static_cast<double>(i) / steps), width * range.length()};
      }
    add(bump, std::move(grid), std::log(range.length()) + std::log(std::log(widest / narrowest)));
    addEdges(form, steps);
  }

  /// Adds steps between the values of the argument, and evenly spaced hinges.
  void addEdges(const Form& form, int steps) {
    if (!m_readings.has(form)) return;
    const Range range = rangeOf(form, steps);
    if (!(range.length() > 0)) return;
    addGrid(with(form, Step), between(form, range), range.length());
    std::vector<double> hinges;
    for (int i = 0; i < steps; ++i) hinges.push_back(range.at((i + 0.5) / steps));
    addGrid(with(form, Hinge), hinges, range.length());
  }

  std::vector<double> between(const Form& form, const Range& range) const {
    constexpr std::size_t most = 24;
    constexpr double apart = 0.005;  // of the range: closer values are the same place
    const VectorXd& of = m_readings.of(form.of);
    std::vector<double> values(of.begin(), of.end()), middles;
    std::ranges::sort(values);
    for (std::size_t i = 1; i < values.size(); ++i)
      if (values[i] - values[i - 1] > apart * range.length() && values[i - 1] >= range.low)
        middles.push_back((values[i] + values[i - 1]) / 2);
    if (middles.size() <= most) return middles;
    const std::size_t each = middles.size() / most + 1;
    std::vector<double> some;
    for (std::size_t i = each / 2; i < middles.size(); i += each) some.push_back(middles[i]);
    return some;
  }
};

}  // namespace

std::vector<FormFamily> formFamilies(const FormReadings& readings) {
  return FamilyMaker(readings).make();
}

Eigen::Array2d shapeCoordinates(const Form& form) {
  if (form.function == FormFunction::Exponential) return {std::log(form.numbers[0]), 0};
  return {form.numbers[0], form.function == FormFunction::Bump ? std::log(form.numbers[1]) : 0};
}

void setShapeCoordinates(Form& form, const Eigen::Array2d& coordinates) {
  form.numbers[0] = form.function == FormFunction::Exponential ? std::exp(coordinates[0]) : coordinates[0];
  if (form.function == FormFunction::Bump) form.numbers[1] = std::exp(coordinates[1]);
}

int wordsOf(const Form& form) {
  using enum FormCarrier;
  const bool turns = form.turnsWithFace && form.of != FormArgument::VerticalCircle;
  const bool staysWithRoom =
      form.of == FormArgument::S && (form.carrier == X || form.carrier == Y || form.carrier == Z);
  return 3 + (turns ? 1 : 0) + (staysWithRoom ? 1 : 0) + form.count();
}

double formUnit(FormCarrier carrier) {
  switch (carrier) {
    case FormCarrier::Across:
      return 0.2;
    case FormCarrier::Slider:
      return 60;
    case FormCarrier::Horizontal:
    case FormCarrier::Vertical:
    case FormCarrier::Orientation:
      return 5;
    default:
      return 0.05;
  }
}

const std::vector<Width>& formWidths() {
  static const std::vector<Width> widths = evenly({0.5, 1, 2, 4, 8, 16, 32, 64});
  return widths;
}

}  // namespace alidade

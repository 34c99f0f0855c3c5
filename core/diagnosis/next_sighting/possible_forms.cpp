#include "core/diagnosis/next_sighting/possible_forms.h"

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "core/diagnosis/forms/form_families.h"
#include "core/diagnosis/forms/form_readings.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

class FormList {
 public:
  std::vector<PossibleForm> make() {
    for (const FormCarrier carrier : {Radial, Across}) addGuideway(carrier);
    for (const FormCarrier carrier : {X, Y, Z}) addCourse({.carrier = carrier, .of = T});
    for (const FormCarrier carrier : {Horizontal, Vertical}) addCircle(carrier);
    addCourse({.carrier = Orientation, .of = T});
    double sum = 0;
    for (const PossibleForm& possible : m_list) sum += possible.share;
    for (PossibleForm& possible : m_list) possible.share /= sum;
    return std::move(m_list);
  }

 private:
  using enum FormCarrier;
  using enum FormFunction;
  using enum FormArgument;

  std::vector<PossibleForm> m_list;

  /// The prior falls by two bits for each word of the form (`wordsOf`), and is divided by `among`. Shape
  /// numbers are no words here: the forms of a family share its prior.
  void add(Form form, FormFunction function, double among = 1) {
    form.function = function;
    m_list.push_back({form, std::exp2(-2 * (wordsOf(form) - form.count())) / among});
  }

  /// `first` is the lowest order that no effect of the catalogue has.
  void addHarmonics(Form form, int first, int last) {
    for (form.order = first; form.order <= last; ++form.order) add(form, Harmonic, form.order);
  }

  void addGuideway(FormCarrier carrier) {
    constexpr int orders = 8, places = 16;
    constexpr double widths[] = {0.1, 0.18, 0.33};  // rad
    Form form{.carrier = carrier, .of = S};
    addHarmonics(form, carrier == Radial ? 4 : 3, orders);
    for (const double width : widths)
      for (int i = 0; i < places; ++i) {
        form.numbers = {std::numbers::pi * (i + 0.5) / places, width};
        add(form, Bump, std::size(widths) * places);
      }
    add({.carrier = carrier, .of = Leg}, Hysteresis);
  }

  void addCircle(FormCarrier carrier) {
    constexpr int orders = 24;
    const bool isVertical = carrier == Vertical;
    addHarmonics({.carrier = carrier,
                  .of = isVertical ? VerticalCircle : HorizontalCircle,
                  .turnsWithFace = isVertical},
                 isVertical ? 3 : 2, orders);
    add({.carrier = carrier, .of = Leg}, Hysteresis);
  }

  void addCourse(Form form) {
    constexpr double constants[] = {0.05, 0.12, 0.3};  // share of the session
    for (const double constant : constants) {
      form.numbers[0] = constant;
      add(form, Exponential, std::size(constants));
    }
    form.numbers = {};
    form.order = 2;
    add(form, Power);
  }
};

/// Returns a fit with arc angles but no readings: `formReadings` then uses the directions of the sightings.
JointFit arcAnglesOn(const std::vector<Circle>& circles, const Measurement& measurement) {
  JointFit fit;
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i) {
    const ArcMeasurement& arc = measurement.arcs[i];
    const ZeroLine line(measurement, arc);
    std::vector<double>& angles = fit.arcAngles.emplace_back();
    for (const Sighting& sighting : arc.sightings)
      angles.push_back(
          sighting.isZero
              ? 0
              : unwrappedArcAngle(nearestArcAngle(circles[i], line.sightedPoint(sighting)), arc.axisDeg));
  }
  return fit;
}

}  // namespace

const std::vector<PossibleForm>& possibleForms() {
  static const std::vector<PossibleForm> list = FormList().make();
  return list;
}

std::vector<Eigen::MatrixXd> columnsOfForms(const PossibleSightings& session,
                                            const std::vector<Circle>& circles, const Linearised& all) {
  const Measurement& measurement = session.measurement;
  const FormReadings readings = formReadings(Leftover(all), measurement, arcAnglesOn(circles, measurement));
  std::vector<Eigen::MatrixXd> list;
  for (const auto& [form, share] : possibleForms()) {
    Eigen::MatrixXd& columns = list.emplace_back();
    if (readings.has(form)) columns = formUnit(form.carrier) * formColumns(readings, form);
  }
  return list;
}

}  // namespace alidade

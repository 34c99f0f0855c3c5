#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/terms/carrier.h"

namespace alidade {

// A form describes an uncatalogued effect as carrier × function of an argument. A form describes the readings
// without naming a cause.

/// Function of the argument x, in this order: cos kx and sin kx; exp(−½((x − at)/width)²); 1 beyond `at`;
/// max(0, x − at); exp(−x/τ); (x/unit)^k; x itself, which is 1 or −1; a random walk in steps of equal length;
/// one number for each value of x.
enum class FormFunction { Harmonic, Bump, Step, Hinge, Exponential, Power, Hysteresis, Walk, PerPlace };

/// `S`: slider coordinate. `T`: elapsed fraction of the session, 0…1. `Azimuth`, `Elevation`: a and e.
/// `HorizontalCircle`, `VerticalCircle`: readings in either face. `Leg`: 1 on the way there, −1 on the way
/// back. `Face`: 1 in face 1, −1 in face 2. `Position`: 1 at 0° and −1 at 180°. `Round`: its number.
enum class FormArgument {
  S,
  T,
  Azimuth,
  Elevation,
  HorizontalCircle,
  VerticalCircle,
  Leg,
  Face,
  Position,
  Round
};

std::string_view nameOf(FormFunction function);
std::string_view nameOf(FormArgument argument);

struct Form {
  FormCarrier carrier = FormCarrier::Radial;
  FormFunction function = FormFunction::Harmonic;
  FormArgument of = FormArgument::S;
  bool turnsWithFace = false;  ///< opposite sign in face 2, like an error of a circle or the line of sight
  int order = 0;               ///< order of a harmonic of an angle, or of a power; otherwise 0
  /// `at` and `width` (rad, or fraction of the session), `tau` (fraction) or `cycles` (per session).
  std::array<double, 2> numbers{};

  /// Whether carrier, function, argument and sign in face 2 are equal; order and numbers may differ.
  bool isOfKind(const Form& other) const;
  /// Number of entries of `numbers` that the function uses.
  int count() const;
  bool isMillimetres() const { return carrier <= FormCarrier::Z; }
  /// Whether the argument is an angle, shown in degrees.
  bool isOfAngle() const {
    return of != FormArgument::T && of != FormArgument::Round && function != FormFunction::Hysteresis;
  }
  /// Whether the form has an amplitude for each place or step.
  bool isFree() const { return function == FormFunction::Walk || function == FormFunction::PerPlace; }
};

/// One number of a form with its standard uncertainty. `name` is "order", "amplitude_mm", "at_deg", ….
struct FormNumber {
  std::string name;
  double value = 0, sigma = 0;
};

/// A look-alike of a form in these readings: another form, or an effect of the catalogue.
struct FormLookAlike {
  Form form = {};
  std::string effect = {};  ///< identifier; empty: `form`
};

/// Reduction of the gap by the forms, 1 − rms after/rms before.
struct FormShrinkage {
  double inSample = 0;
  /// On readings that were held out of the fit of circles, shape and amplitudes. Not a number if too few
  /// readings exist; the same holds for `f` and `p`.
  double heldOut = 0;
  /// Exact F test of the hypothesis that the form predicts nothing of the held-out readings: F, and the
  /// probability of at least this F by noise alone.
  double f = 0, p = 1;
  int heldOutReadings = 0;
};

/// The value of a form at a sighting, mm or arcseconds; reduced to face 1 if the sign changes with the face.
struct FormPoint {
  std::size_t position = 0, row = 0;  ///< indices in the session
  bool isVertical = false;            ///< for an orientation: values of the vertical circle
  double at = 0;                      ///< argument: degrees, share of the session, or ±1
  double before = 0, after = 0;       ///< partial residual without this form; residual with it
  double heldOut = 0;  ///< `after` as predicted without this sighting; not a number if it was never held out
};

struct FormTrace {
  std::vector<FormPoint> points = {};  ///< sightings with at most five times the least σ
  /// Argument, ascending, and two values of the form: horizontal and vertical for an orientation, else equal.
  std::vector<std::array<double, 3>> curve = {};
  double sigma = 0;  ///< least σ of a form's value from one sighting, with the stated noise
};

struct FoundForm {
  Form form;
  /// "radial = A*cos(7*s) + B*sin(7*s)".
  std::string formula;
  /// Coefficients of `formula`: A, B, …, mm or arcseconds.
  std::vector<FormNumber> coefficients = {};
  std::vector<double> places = {};  ///< places of a free form's coefficients: rad, or share of the session
  std::vector<FormNumber> parameters = {};  ///< shape numbers and amplitudes
  double probability = 0;                   ///< probability among all forms and patterns, 0…1
  std::vector<FormLookAlike> indistinguishableFrom = {};
  FormShrinkage shrink = {};
  /// Ranges of the argument, from … to, in which the form displaces every reading by less than its σ; degrees
  /// or share of the session. Empty for forms that act everywhere, such as a harmonic.
  std::vector<std::array<double, 2>> cleanRange = {};
  FormTrace trace = {};  ///< only of a form found in a session
};

}  // namespace alidade

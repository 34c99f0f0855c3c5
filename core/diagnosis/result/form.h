#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

// A form: an effect of no catalogue, described as carrier × function of an argument. A form says what the
// readings do, never why.

/// What is displaced. `Radial`, `Tangential`, `Across`: the target, mm, turning with the guideway. `X`, `Y`,
/// `Z`: the target, mm in o0. `Horizontal`, `Vertical`: one circle, arcseconds. `Orientation`: both circles,
/// each with its own amplitudes, arcseconds. `Slider`: its reading, arcseconds.
enum class FormCarrier { Radial, Tangential, Across, X, Y, Z, Horizontal, Vertical, Orientation, Slider };

/// Of the argument x: cos kx and sin kx; exp(−½((x − at)/width)²); 1 beyond `at`; max(0, x − at); exp(−x/τ);
/// (x/unit)^k; x itself, which is 1 or −1; a sum of steps, one for each part of the session; a number for
/// each value of x.
enum class FormFunction { Harmonic, Bump, Step, Hinge, Exponential, Power, Hysteresis, Walk, PerPlace };

/// `S`: slider coordinate. `T`: elapsed share of the session, 0…1. `Azimuth`, `Elevation`: a and e. The
/// circles: as read in either face. `Leg`: 1 there and −1 back. `Face`: 1 and −1. `Position`: 1 at 0° and −1
/// at 180°. `Round`: its number.
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

std::string_view nameOf(FormCarrier carrier);
std::string_view nameOf(FormFunction function);
std::string_view nameOf(FormArgument argument);

struct Form {
  FormCarrier carrier = FormCarrier::Radial;
  FormFunction function = FormFunction::Harmonic;
  FormArgument of = FormArgument::S;
  bool turnsWithFace = false;  ///< the other sign in face 2, as an error of a circle or the line of sight has
  int order = 0;               ///< of a harmonic of an angle, or of a power; else 0
  /// at and width (rad, or share of the session), tau or cycles (share, per session).
  std::array<double, 2> numbers{};

  /// Carrier, function, argument and turning are the same; order and numbers may differ.
  bool isOfKind(const Form& other) const;
  /// How many of `numbers` its function has.
  int count() const;
  bool isMillimetres() const { return carrier <= FormCarrier::Z; }
  /// Its argument is an angle, told in degrees.
  bool isOfAngle() const {
    return of != FormArgument::T && of != FormArgument::Round && function != FormFunction::Hysteresis;
  }
  /// It has as many amplitudes as the readings have places or parts.
  bool isFree() const { return function == FormFunction::Walk || function == FormFunction::PerPlace; }
};

/// One number of a form with its standard uncertainty. `name`: "order", "amplitude_mm", "at_deg", ….
struct FormNumber {
  std::string name;
  double value = 0, sigma = 0;
};

/// What these readings cannot tell from a form: another form, or an effect of the catalogue.
struct FormLookAlike {
  Form form = {};
  std::string effect = {};  ///< id; empty: `form`
};

/// How far the gap shrinks with the forms in the model, 1 − rms after/rms before.
struct FormShrinkage {
  double inSample = 0;
  /// On readings that took no part in estimating circles, shape and amplitudes. Not a number where too few
  /// are there, like `f` and `p`.
  double heldOut = 0;
  /// Exact test on those readings that the form predicts nothing: F with its probability under noise alone.
  double f = 0, p = 1;
  int heldOutReadings = 0;
};

/// What a sighting says of a form, mm or arcseconds; face 1 where it turns over.
struct FormPoint {
  std::size_t position = 0, row = 0;  ///< of the session
  bool isVertical = false;            ///< of an orientation: of the vertical circle
  double at = 0;                      ///< argument: degrees, share of the session, or ±1
  double before = 0, after = 0;       ///< with everything but this form in the model, and with it
  double heldOut = 0;  ///< after, by what is found without this sighting; not a number where it never is
};

struct FormTrace {
  std::vector<FormPoint> points = {};  ///< of the sightings that show the form sharply
  /// Argument and form from the least to the largest argument; of an orientation horizontal, then vertical.
  std::vector<std::array<double, 3>> curve = {};
  double sigma = 0;  ///< of the sharpest of these sightings, by the stated noise
};

struct FoundForm {
  Form form;
  /// "radial = A*cos(7*s) + B*sin(7*s)".
  std::string formula;
  /// Of `formula`: A, B, …, mm or arcseconds.
  std::vector<FormNumber> coefficients = {};
  std::vector<double> places = {};  ///< of the coefficients of a free form: rad, or share of the session
  std::vector<FormNumber> parameters = {};  ///< shape numbers and amplitudes
  double probability = 0;                   ///< that it is the right one of all forms and patterns, 0…1
  std::vector<FormLookAlike> indistinguishableFrom = {};
  FormShrinkage shrink = {};
  /// Where the form displaces every reading by less than its σ, from … to: degrees or share of the session.
  /// Empty of what goes on everywhere, such as a harmonic.
  std::vector<std::array<double, 2>> cleanRange = {};
  FormTrace trace = {};  ///< of a session
};

}  // namespace alidade

#include "core/diagnosis/candidates/session_patterns.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "core/base/phrase.h"
#include "core/observation/half_turn.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// The change of the readings by a weight of 1.
enum class Along {
  Radius,    ///< 0.05 mm of the radius
  Across,    ///< 0.2 mm across the plane, turning with the guideway
  Slider,    ///< 60″ of the slider readings
  Distance,  ///< 1 mm of the distance, equal at all axis angles
  Horizontal,
  Vertical,         ///< 5″ of the face-1 equivalents, like `Horizontal`
  Both,             ///< both circles, with separate weights
  HorizontalFaces,  ///< like `Horizontal`, with the opposite sign in face 2
  VerticalFaces,
  HorizontalCircle,  ///< 5″ of the readings of either face
  VerticalCircle,
};
enum class Of { Guideway, Time, Azimuth, Elevation, Circle, Leg };
enum class Course {
  Harmonic,  ///< cosine and sine of `Recipe::number` periods in a turn
  Smooth,    ///< `Recipe::number` half waves; shorter waves have smaller amplitudes
  Settling,  ///< fast, medium and slow decay
  WayBack,   ///< 1 in even rounds, 0 in odd rounds
};

struct Recipe {
  const char* follows;
  ErrorSource source;
  Along along;
  Of of;
  Course form;
  int number = 0;  ///< number of the harmonic, or of half waves

  Index functions() const {
    switch (form) {
      case Course::Harmonic:
        return 2;
      case Course::Smooth:
        return number;
      case Course::Settling:
        return 3;
      case Course::WayBack:
        break;
    }
    return 1;
  }
  Index columns() const { return along == Along::Both ? 2 * functions() : functions(); }
};

void addHarmonics(std::vector<Recipe>& recipes, Recipe recipe, std::initializer_list<int> orders) {
  recipe.form = Course::Harmonic;
  for (const int order : orders) {
    recipe.number = order;
    recipes.push_back(recipe);
  }
}

std::vector<Recipe> makeRecipes() {
  using enum Along;
  constexpr int manyWaves = 12, waves = 6, fewWaves = 4;
  std::vector<Recipe> list;
  const char* const radius = PHRASE_LATER("Phrase", "radius along the guideway");
  const char* const plane = PHRASE_LATER("Phrase", "guideway out of its plane");
  const char* const slider = PHRASE_LATER("Phrase", "slider readings along the scale");
  ErrorSource source = ErrorSource::Guideway;
  const auto add = [&](const char* follows, Along along, Of of, Course form, int number = 0) {
    list.push_back({follows, source, along, of, form, number});
  };
  addHarmonics(list, {radius, source, Radius, Of::Guideway, {}}, {4, 5, 6, 7, 8, 9, 10, 11, 12});
  addHarmonics(list, {plane, source, Across, Of::Guideway, {}}, {1, 3, 4, 5, 6, 7, 8});
  addHarmonics(list, {slider, source, Slider, Of::Guideway, {}}, {2, 3, 4, 5, 6, 7, 8});
  add(PHRASE_LATER("Phrase", "radius from place to place, turning with the guideway"), Radius, Of::Guideway,
      Course::Smooth, manyWaves);
  add(PHRASE_LATER("Phrase", "guideway out of its plane from place to place"), Across, Of::Guideway,
      Course::Smooth, manyWaves);
  add(PHRASE_LATER("Phrase", "slider readings from place to place"), Slider, Of::Guideway, Course::Smooth,
      manyWaves);
  add(PHRASE_LATER("Phrase", "radius on the way back"), Radius, Of::Leg, Course::WayBack);
  source = ErrorSource::Instrument;
  addHarmonics(list,
               {PHRASE_LATER("Phrase", "horizontal readings along their circle"),
                source,
                HorizontalCircle,
                Of::Circle,
                {}},
               {2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24});
  addHarmonics(list,
               {PHRASE_LATER("Phrase", "vertical readings along their circle"),
                source,
                VerticalCircle,
                Of::Circle,
                {}},
               {2, 3, 4, 5, 6, 8, 12, 16, 24});
  add(PHRASE_LATER("Phrase", "horizontal readings varying with azimuth"), Horizontal, Of::Azimuth,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "vertical readings varying with elevation"), Vertical, Of::Elevation,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "horizontal readings varying with elevation"), Horizontal, Of::Elevation,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "vertical readings varying with azimuth"), Vertical, Of::Azimuth, Course::Smooth,
      waves);
  add(PHRASE_LATER("Phrase", "difference of the faces, horizontal"), HorizontalFaces, Of::Elevation,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "difference of the faces, vertical"), VerticalFaces, Of::Elevation,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "horizontal readings on the way back"), Horizontal, Of::Leg, Course::WayBack);
  add(PHRASE_LATER("Phrase", "vertical readings on the way back"), Vertical, Of::Leg, Course::WayBack);
  source = ErrorSource::Time;
  add(PHRASE_LATER("Phrase", "orientation settling with time"), Both, Of::Time, Course::Settling);
  add(PHRASE_LATER("Phrase", "horizontal orientation varying with time"), Horizontal, Of::Time,
      Course::Smooth, waves);
  add(PHRASE_LATER("Phrase", "vertical orientation varying with time"), Vertical, Of::Time, Course::Smooth,
      waves);
  add(PHRASE_LATER("Phrase", "distance varying with time"), Distance, Of::Time, Course::Smooth, fewWaves);
  return list;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = makeRecipes();
  return all;
}

/// The readings of one session, and the arguments of the patterns.
class Readings {
 public:
  Readings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit)
      : m_leftover(leftover),
        m_measurement(measurement),
        m_fit(fit),
        m_horizontal(leftover.column(ErrorTerm::HorizontalJump)),
        m_vertical(leftover.column(ErrorTerm::VerticalJump)) {}

  MatrixXd columns(const Recipe& recipe) const {
    const MatrixXd functions = functionsOf(recipe);
    if (recipe.along != Along::Both) return carrier(recipe.along).asDiagonal() * functions;
    MatrixXd both(functions.rows(), 2 * functions.cols());
    both << carrier(Along::Horizontal).asDiagonal() * functions,
        carrier(Along::Vertical).asDiagonal() * functions;
    return both;
  }

 private:
  const Leftover& m_leftover;
  const Measurement& m_measurement;
  const JointFit& m_fit;
  VectorXd m_horizontal, m_vertical;

  const ArcMeasurement& arcOf(Index i) const { return m_measurement.arcs[m_leftover.reading(i).arc]; }
  const Sighting& rowOf(Index i) const { return arcOf(i).sightings[m_leftover.reading(i).sighting]; }

  template <typename Value>
  VectorXd each(const Value& value) const {
    VectorXd values(m_leftover.readings());
    for (Index i = 0; i < values.size(); ++i) values[i] = value(i);
    return values;
  }

  VectorXd carrier(Along along) const {
    const double seconds = Angle::fromArcseconds(5).radians(), slider = Angle::fromArcseconds(60).radians();
    const auto face = each([&](Index i) { return rowOf(i).face == 1 ? 1 : -1; });
    switch (along) {
      case Along::Radius:
        return 0.05 * m_leftover.column(Unknown::Kind::Radius);
      case Along::Across:
        return 0.2 * m_leftover.column(ErrorTerm::PlaneOffset);
      case Along::Slider:
        return slider * m_leftover.column(Unknown::Kind::SliderZero);
      case Along::Distance:
        return m_leftover.column(ErrorTerm::PlaneOffset).cwiseProduct(each([&](Index i) {
          return halfTurnSign(arcOf(i).axisDeg);
        }));
      case Along::Horizontal:
      case Along::HorizontalCircle:
      case Along::Both:
        return seconds * m_horizontal;
      case Along::Vertical:
      case Along::VerticalCircle:
        return seconds * m_vertical;
      case Along::HorizontalFaces:
        return seconds * m_horizontal.cwiseProduct(face);
      case Along::VerticalFaces:
        break;
    }
    return seconds * m_vertical.cwiseProduct(face);
  }

  /// Returns cosine and sine of `number` periods of the circle reading, minus cosine and sine of the pointing
  /// zero in face 1. In face 2 the vertical circle counts in the opposite direction.
  MatrixXd circleFunctions(const Recipe& recipe) const {
    const bool isHorizontal = recipe.along == Along::HorizontalCircle,
               isZenith = m_measurement.verticalCircle == VerticalCircle::Zenith;
    const double half = std::numbers::pi, whole = isZenith ? 2 * half : half;
    MatrixXd functions(m_leftover.readings(), 2);
    for (Index i = 0; i < functions.rows(); ++i) {
      const Sighting& row = rowOf(i);
      const bool isTurned = row.face != 1;
      const double zero = (isHorizontal ? arcOf(i).zeroHorizontal : arcOf(i).zeroVertical).radians();
      double at = 0, side = 1;
      if (isHorizontal) {
        at = zero + row.a.radians() + (isTurned ? half : 0);
      } else {
        at = zero + (isZenith ? -row.e.radians() : row.e.radians());
        if (isTurned) at = whole - at;
        if (isTurned) side = -1;
      }
      functions(i, 0) = side * std::cos(recipe.number * at) - std::cos(recipe.number * zero);
      functions(i, 1) = side * std::sin(recipe.number * at) - std::sin(recipe.number * zero);
    }
    return functions;
  }

  double sliderCoordinate(Index i) const {
    const LinearReading& reading = m_leftover.reading(i);
    return sliderCoordinateOf(m_fit.arcAngles[reading.arc][reading.sighting], arcOf(i).axisDeg);
  }

  /// Returns the argument of the functions: an angle for harmonics, otherwise 0…1.
  VectorXd argument(const Recipe& recipe) const {
    const double widest = std::atan2(m_measurement.nominalRadius, m_measurement.distance);
    const auto share = [&](double angle) { return (angle / widest + 1) / 2; };
    switch (recipe.of) {
      case Of::Guideway:
        return each([&](Index i) {
          return recipe.form == Course::Harmonic ? sliderCoordinate(i)
                                                 : sliderCoordinate(i) / std::numbers::pi;
        });
      case Of::Time:
        return each([&](Index i) {
          return static_cast<double>(rowOf(i).sequence) /
                 static_cast<double>(std::max<std::size_t>(m_measurement.rows, 2) - 1);
        });
      case Of::Azimuth:
        return each([&](Index i) { return share(rowOf(i).a.radians()); });
      case Of::Elevation:
        return each([&](Index i) { return share(rowOf(i).e.radians()); });
      case Of::Circle:
      case Of::Leg:
        break;
    }
    return each([&](Index i) { return rowOf(i).round % 2 == 0 ? 1 : 0; });
  }

  MatrixXd functionsOf(const Recipe& recipe) const {
    if (recipe.of == Of::Circle) return circleFunctions(recipe);
    const VectorXd at = argument(recipe);
    MatrixXd functions(at.size(), recipe.functions());
    switch (recipe.form) {
      case Course::Harmonic:
        functions << (recipe.number * at.array()).cos(), (recipe.number * at.array()).sin();
        break;
      case Course::Smooth:
        for (int k = 1; k <= recipe.number; ++k)
          functions.col(k - 1) = (k * std::numbers::pi * at.array()).cos() / std::sqrt(k);
        break;
      case Course::Settling:
        functions << (-at / 0.05).array().exp(), (-at / 0.15).array().exp(), (-at / 0.4).array().exp();
        break;
      case Course::WayBack:
        functions = at;
        break;
    }
    return functions;
  }
};

}  // namespace

const std::vector<SessionPattern>& sessionPatterns() {
  static const std::vector<SessionPattern> all = [] {
    std::vector<SessionPattern> patterns;
    for (const Recipe& recipe : recipes())
      patterns.push_back({{.id = recipe.follows,
                           .name = recipe.follows,
                           .description = recipe.follows,
                           .remedy = "",
                           .source = recipe.source,
                           .response = Response::Linear,
                           .parameters = {}},
                          recipe.form == Course::Harmonic ? recipe.number : 0,
                          recipe.columns()});
    return patterns;
  }();
  return all;
}

MatrixXd patternColumns(const Leftover& leftover, const Measurement& measurement, const JointFit& fit) {
  constexpr Index mostReadings = 20'000;
  Index count = 0;
  for (const SessionPattern& pattern : sessionPatterns()) count += pattern.columns;
  if (leftover.readings() > mostReadings) return MatrixXd::Zero(leftover.rows(), count);
  const Readings readings(leftover, measurement, fit);
  MatrixXd columns(leftover.readings(), count);
  Index first = 0;
  for (const Recipe& recipe : recipes()) {
    columns.middleCols(first, recipe.columns()) = readings.columns(recipe);
    first += recipe.columns();
  }
  return leftover.visible(columns);
}

}  // namespace alidade

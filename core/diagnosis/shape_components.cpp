#include "core/diagnosis/shape_components.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::RowVectorXd, Eigen::VectorXd;

namespace {

constexpr double invisible = 1e-5;  // σ over all readings: rounding

/// What a pattern may follow, reading by reading.
struct Surroundings {
  VectorXd radial, offPlane, slider, horizontal, vertical;  ///< effect of 1 unit on each reading
  VectorXd s, elapsed, a, e, side;
  VectorXd towards;  ///< effect of the target 1 mm nearer
  std::vector<int> arc, round, face;
  std::vector<std::pair<std::size_t, int>> place;  ///< arc and point
};

Surroundings surroundingsOf(const Leftover& leftover, const Measurement& measurement, const JointFit& fit) {
  const Index n = leftover.readings();
  Surroundings all{leftover.column(Unknown::Kind::Radius),
                   leftover.column(ErrorTerm::PlaneOffset),
                   leftover.column(Unknown::Kind::SliderZero),
                   leftover.column(ErrorTerm::HorizontalJump),
                   leftover.column(ErrorTerm::VerticalJump),
                   VectorXd(n),
                   VectorXd(n),
                   VectorXd(n),
                   VectorXd(n),
                   VectorXd(n),
                   leftover.column(ErrorTerm::PlaneOffset),
                   {},
                   {},
                   {},
                   {}};
  for (Index i = 0; i < n; ++i) {
    const LinearReading& reading = leftover.reading(i);
    const ArcMeasurement& arc = measurement.arcs[reading.arc];
    const Sighting& sighting = arc.sightings[reading.sighting];
    all.s[i] = (arc.axisDeg == 0 ? 1 : -1) * fit.arcAngles[reading.arc][reading.sighting];
    all.elapsed[i] = static_cast<double>(sighting.sequence) /
                     static_cast<double>(std::max<std::size_t>(measurement.rows, 2) - 1);
    if (arc.axisDeg != 0) all.towards[i] = -all.towards[i];  // the plane's offset turns with the guideway
    all.a[i] = sighting.a.radians();
    all.e[i] = sighting.e.radians();
    all.side[i] = sighting.face == 1 ? 1 : -1;
    all.arc.push_back(static_cast<int>(reading.arc));
    all.round.push_back(sighting.round);
    all.face.push_back(sighting.face);
    all.place.emplace_back(reading.arc, sighting.point);
  }
  return all;
}

RowVectorXd smooth(double where, int count) {
  RowVectorXd values(count);
  for (int k = 1; k <= count; ++k) values[k - 1] = std::cos(k * std::numbers::pi * where) / k;
  return values;
}

/// What dies away after the start of the session, quickly, in between and slowly.
RowVectorXd settling(double elapsed) {
  return Eigen::RowVector3d(std::exp(-elapsed / 0.05), std::exp(-elapsed / 0.15), std::exp(-elapsed / 0.4));
}

/// Cosine and sine of 0 to `count` times each angle: orders × angles.
struct Harmonics {
  MatrixXd cosines, sines;
};

Harmonics harmonicsOf(const VectorXd& angles, int count) {
  Harmonics harmonics{MatrixXd(count + 1, angles.size()), MatrixXd(count + 1, angles.size())};
  for (Index i = 0; i < angles.size(); ++i) {
    const std::complex<double> turn = std::polar(1.0, angles[i]);
    std::complex<double> wave = 1;
    for (int order = 0; order <= count; ++order, wave *= turn) {
      harmonics.cosines(order, i) = wave.real();
      harmonics.sines(order, i) = wave.imag();
    }
  }
  return harmonics;
}

class ShapeMaker {
 public:
  explicit ShapeMaker(const Leftover& leftover) : m_leftover(leftover) {}

  /// `carrier` times a function that differs from group to group.
  template <typename Group>
  void addGroups(const std::string& id, const VectorXd& carrier, const Group& groupOf) {
    std::map<std::decay_t<decltype(groupOf(0))>, Index> groups;
    for (Index i = 0; i < carrier.size(); ++i)
      if (carrier[i] != 0) groups.emplace(groupOf(i), static_cast<Index>(groups.size()));
    if (groups.size() < 2 || groups.size() > mostGroups) return;
    SparseColumns columns(static_cast<Index>(groups.size()));
    for (Index i = 0; i < carrier.size(); ++i)
      if (carrier[i] != 0) columns.add(i, groups.at(groupOf(i)), RowVectorXd::Constant(1, carrier[i]));
    add(id, std::move(columns));
  }

  void addHarmonic(const std::string& id, const VectorXd& carrier, const Harmonics& harmonics, int order) {
    addFunctions(id, carrier, 2, [&](Index i) {
      return Eigen::RowVector2d(harmonics.cosines(order, i), harmonics.sines(order, i));
    });
  }

  /// Cosines of 1 to `count` half waves over 0…1, the shorter the weaker.
  void addSmooth(const std::string& id, const VectorXd& carrier, const VectorXd& where, int count) {
    addFunctions(id, carrier, count, [&](Index i) { return smooth(where[i], count); });
  }

  /// `count` functions of the reading, each with weights of its own for the two circles.
  template <typename Functions>
  void addOrientation(const std::string& id, const VectorXd& horizontal, const VectorXd& vertical,
                      Index count, const Functions& functions) {
    SparseColumns columns(2 * count);
    for (Index i = 0; i < horizontal.size(); ++i) {
      if (horizontal[i] != 0) columns.add(i, 0, horizontal[i] * functions(i));
      if (vertical[i] != 0) columns.add(i, count, vertical[i] * functions(i));
    }
    add(id, std::move(columns));
  }

  std::vector<Component> take(double odds) {
    for (Component& component : m_components)
      component.logPrior = std::log(odds / static_cast<double>(m_components.size()));
    return std::move(m_components);
  }

 private:
  static constexpr std::size_t mostGroups = 80;
  const Leftover& m_leftover;
  std::vector<Component> m_components;

  template <typename Functions>
  void addFunctions(const std::string& id, const VectorXd& carrier, Index count, const Functions& functions) {
    SparseColumns columns(count);
    for (Index i = 0; i < carrier.size(); ++i)
      if (carrier[i] != 0) columns.add(i, 0, carrier[i] * functions(i));
    add(id, std::move(columns));
  }

  /// Scaled so that a weight of 1 moves the readings it moves by 1σ in the mean.
  void add(const std::string& id, SparseColumns columns) {
    if (columns.runs() == 0) return;
    columns.scale(std::sqrt(static_cast<double>(columns.runs()) / columns.squaredNorm()));
    MatrixXd gram = m_leftover.visibleGram(columns);
    if (gram.trace() < invisible * invisible) return;
    m_components.push_back(
        {.kind = Component::Kind::Shape, .id = id, .pattern = std::move(columns), .gram = std::move(gram)});
  }
};

VectorXd toUnit(const VectorXd& values) {
  const double least = values.minCoeff(), range = values.maxCoeff() - least;
  return range > 0 ? VectorXd((values.array() - least) / range) : VectorXd::Zero(values.size());
}

}  // namespace

std::vector<Component> shapeComponents(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit, const std::vector<std::string>& leftOut,
                                       const PriorOdds& odds) {
  const Surroundings all = surroundingsOf(leftover, measurement, fit);
  ShapeMaker maker(leftover);
  const Harmonics harmonics = harmonicsOf(all.s, 12);
  const auto left = [&](const char* id) { return std::ranges::find(leftOut, id) != leftOut.end(); };
  for (int order = 2; order <= 12; ++order)
    if (order > 3 || left(order == 2 ? "arc_ellipticity" : "arc_lobing"))
      maker.addHarmonic("radius along the guideway", all.radial, harmonics, order);
  for (int order = 1; order <= 8; ++order)
    if (order != 2 || left("plane_warp"))
      maker.addHarmonic("guideway out of its plane", all.offPlane, harmonics, order);
  for (int order = 2; order <= 8; ++order)
    maker.addHarmonic("slider readings along the scale", all.slider, harmonics, order);
  const auto point = [&](Index i) { return all.place[static_cast<std::size_t>(i)].second; };
  maker.addGroups("radius from place to place, turning with the guideway", all.radial, point);
  maker.addGroups("guideway out of its plane from place to place", all.offPlane, point);
  maker.addGroups("slider readings from place to place", all.slider, point);
  const auto place = [&](Index i) { return all.place[static_cast<std::size_t>(i)]; };
  maker.addGroups("radius from place to place in each position", all.radial, place);
  maker.addSmooth("horizontal orientation with time", all.horizontal, all.elapsed, 10);
  maker.addSmooth("vertical orientation with time", all.vertical, all.elapsed, 10);
  constexpr int waves = 10;
  maker.addOrientation("orientation with time", all.horizontal, all.vertical, waves,
                       [&](Index i) { return smooth(all.elapsed[i], waves); });
  maker.addOrientation("orientation settling with time", all.horizontal, all.vertical, 3,
                       [&](Index i) { return settling(all.elapsed[i]); });
  maker.addSmooth("distance with time", all.towards, all.elapsed, 4);
  maker.addSmooth("slider readings along the scale", all.slider, toUnit(all.s), 6);
  const VectorXd alpha = toUnit(all.a), epsilon = toUnit(all.e);
  maker.addSmooth("horizontal readings with azimuth", all.horizontal, alpha, 6);
  maker.addSmooth("vertical readings with elevation", all.vertical, epsilon, 6);
  maker.addSmooth("horizontal readings with elevation", all.horizontal, epsilon, 6);
  maker.addSmooth("vertical readings with azimuth", all.vertical, alpha, 6);
  const VectorXd oddHorizontal = all.horizontal.cwiseProduct(all.side),
                 oddVertical = all.vertical.cwiseProduct(all.side);
  maker.addSmooth("difference of the faces, horizontal", oddHorizontal, epsilon, 6);
  maker.addSmooth("difference of the faces, vertical", oddVertical, epsilon, 6);
  const auto block = [&](Index i) {
    const auto k = static_cast<std::size_t>(i);
    return std::tuple(all.arc[k], all.round[k], all.face[k]);
  };
  maker.addGroups("horizontal orientation from round to round", all.horizontal, block);
  maker.addGroups("vertical orientation from round to round", all.vertical, block);
  return maker.take(odds.shape);
}

}  // namespace alidade

#include "core/diagnosis/candidates/shape_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/base/phrase.h"
#include "core/observation/half_turn.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixXf, Eigen::VectorXd;

namespace {

constexpr double invisible = 1e-5;  // length in σ; shorter columns are rounding errors

using SharedCarrier = std::shared_ptr<const Carrier>;
using SharedCells = std::shared_ptr<const Cells>;

/// Returns the adjusted directions of the sightings of each arc, rad. Observed directions are unsuitable: a
/// function of a noisy direction follows the noise, and explains it if the noise is large compared with the
/// range of directions.
std::vector<std::vector<Direction<double>>> adjustedDirections(const Measurement& measurement,
                                                               const JointFit& fit) {
  std::vector<std::vector<Direction<double>>> directions;
  for (const ArcMeasurement& arc : measurement.arcs) {
    std::vector<Direction<double>>& own = directions.emplace_back();
    own.reserve(arc.sightings.size());
    for (const Sighting& sighting : arc.sightings)
      own.push_back({sighting.a.radians(), sighting.e.radians()});
  }
  for (const AdjustedReading& reading : fit.readings) {
    Direction<double>& direction = directions[reading.arc][reading.sighting];
    if (reading.kind == ReadingKind::Horizontal) direction.a -= reading.residual;
    if (reading.kind == ReadingKind::Vertical) direction.e -= reading.residual;
  }
  return directions;
}

/// The arguments of patterns: one value per visit for the guideway, one per row for the instrument.
class Surroundings {
 public:
  Surroundings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit)
      : m_leftover(leftover),
        m_measurement(measurement),
        visits(cellsOf([&](Index i, Index j) { return at(i).visit == at(j).visit; })),
        rows(cellsOf([&](Index i, Index j) {
          // Slider readings are independent of the instrument, so they form no cell of their own.
          return at(i).visit == at(j).visit &&
                 (at(i).sighting == at(j).sighting || at(j).kind == ReadingKind::Slider);
        })) {
    s = visits->values([&](Index i) {
      if (at(i).isZero) return sliderCoordinateOf(fit.arcAngles[at(i).arc].front(), arcOf(i).axisDeg);
      return sliderCoordinateOf(fit.arcAngles[at(i).arc][at(i).sighting], arcOf(i).axisDeg);
    });
    elapsed = rows->values([&](Index i) { return rowOf(i).elapsed; });
    const auto directions = adjustedDirections(measurement, fit);
    a = rows->values([&](Index i) { return directions[at(i).arc][at(i).sighting].a; });
    e = rows->values([&](Index i) { return directions[at(i).arc][at(i).sighting].e; });
  }

 private:
  const Leftover& m_leftover;
  const Measurement& m_measurement;

 public:
  SharedCells visits, rows;
  VectorXd s;        ///< slider coordinate of each visit, rad
  VectorXd elapsed;  ///< share of the session elapsed at each row, 0…1
  VectorXd a, e;     ///< adjusted direction of each row, rad

  const ArcMeasurement& arcOf(Index reading) const { return m_measurement.arcs[at(reading).arc]; }
  const Sighting& rowOf(Index reading) const { return arcOf(reading).sightings[at(reading).sighting]; }
  const LinearReading& at(Index reading) const { return m_leftover.reading(reading); }

  /// Returns the carrier of `values`, the change of each reading by a function value of 1.
  SharedCarrier alongGuideway(const VectorXd& values) { return carrierOf(values, visits); }
  SharedCarrier ofInstrument(const VectorXd& values) { return carrierOf(values, rows); }
  /// Returns the carrier of `values`, with the opposite sign where `turned` returns true.
  template <typename Turned>
  SharedCarrier ofInstrument(VectorXd values, const Turned& turned) {
    for (Index i = 0; i < values.size(); ++i)
      if (turned(i)) values[i] = -values[i];
    return ofInstrument(values);
  }

 private:
  template <typename Same>
  SharedCells cellsOf(const Same& same) const {
    return std::make_shared<const Cells>(m_leftover.readings(), same);
  }
  SharedCarrier carrierOf(const VectorXd& values, const SharedCells& cells) {
    return std::make_shared<const Carrier>(m_leftover, values, cells);
  }
};

/// Returns cosine and sine of 0 to `count` times each angle, alternating: angles × 2 (count + 1).
MatrixXf harmonicsOf(const VectorXd& angles, int count) {
  MatrixXf harmonics(angles.size(), 2 * (count + 1));
  for (Index i = 0; i < angles.size(); ++i) {
    const std::complex<double> turn = std::polar(1.0, angles[i]);
    std::complex<double> wave = 1;
    for (int order = 0; order <= count; ++order, wave *= turn) {
      harmonics(i, 2 * order) = static_cast<float>(wave.real());
      harmonics(i, 2 * order + 1) = static_cast<float>(wave.imag());
    }
  }
  return harmonics;
}

/// Returns the cosines of 1 to `count` half waves over 0…1; shorter waves have smaller amplitudes.
MatrixXf smooth(const VectorXd& where, int count) {
  MatrixXf values(where.size(), count);
  for (Index i = 0; i < where.size(); ++i) {
    const std::complex<double> turn = std::polar(1.0, where[i] * std::numbers::pi);
    std::complex<double> wave = turn;
    for (int k = 1; k <= count; ++k, wave *= turn) values(i, k - 1) = static_cast<float>(wave.real() / k);
  }
  return values;
}

/// Returns the number of half waves for an orientation that changes with time. With few rows the unknowns
/// absorb the slow waves almost completely. With many rows the slow waves alone distinguish the change from
/// noise: fewer waves suffice, and the computing time stays the same.
int wavesOf(Index rows) {
  constexpr Index fewest = 10, forRows = 136;
  if (rows < 2) return 0;
  return static_cast<int>(std::min(rows - 1, std::max(fewest, fewest * forRows / rows)));
}

/// Returns fast, medium and slow decay after the start of the session.
MatrixXf settling(const VectorXd& elapsed) {
  MatrixXd values(elapsed.size(), 3);
  values << (-elapsed / 0.05).array().exp(), (-elapsed / 0.15).array().exp(), (-elapsed / 0.4).array().exp();
  return values.cast<float>();
}

class ShapeMaker {
 public:
  explicit ShapeMaker(const Leftover& leftover) : m_leftover(leftover) {}

  /// Sets the source of the patterns added from here on.
  void startSource(ErrorSource source) { m_source = source; }

  /// Adds the pattern of one carrier and its functions.
  void add(std::string_view id, const SharedCarrier& carrier, const CellFunctions& functions) {
    add(id, Pattern{{{carrier, functions}}});
  }

  /// Adds a pattern with a separate value for each group, if there are 2 to `mostGroups` groups.
  template <typename Group>
  void addGroups(std::string_view id, const SharedCarrier& carrier, const SharedCells& cells,
                 const Group& groupOf) {
    std::map<std::decay_t<decltype(groupOf(0))>, Index> groups;
    const auto moves = [&](Index cell) { return carrier->squares()[cell] > 0; };
    const auto group = [&](Index cell) { return groupOf(cells->readingOf(cell)); };
    for (Index cell = 0; cell < carrier->cells(); ++cell)
      if (moves(cell)) groups.emplace(group(cell), static_cast<Index>(groups.size()));
    if (groups.size() < 2 || groups.size() > mostGroups) return;
    const auto count = static_cast<Index>(groups.size());
    std::vector<Index> ofCells(static_cast<std::size_t>(carrier->cells()), -1);
    for (Index cell = 0; cell < carrier->cells(); ++cell)
      if (moves(cell)) ofCells[static_cast<std::size_t>(cell)] = groups.at(group(cell));
    MatrixXd gram = carrier->visibleGramOfGroups(m_leftover, ofCells, count);
    add(id, Pattern{{{carrier, CellFunctions(std::move(ofCells), count)}}}, std::move(gram));
  }

  /// Adds a pattern for each order. Their inner products are computed together.
  void addHarmonics(std::string_view id, const SharedCarrier& carrier, const CellFunctions& harmonics,
                    const std::vector<int>& orders) {
    std::vector<Index> all;
    for (const Index order : orders) all.insert(all.end(), {2 * order, 2 * order + 1});
    const MatrixXd gram = Pattern{{{carrier, harmonics.chosen(all)}}}.visibleGram(m_leftover);
    Index first = 0;
    for (const Index order : orders) {
      add(id, Pattern{{{carrier, harmonics.chosen({2 * order, 2 * order + 1})}}},
          gram.block(first, first, 2, 2));
      first += 2;
    }
  }

  /// Adds functions with separate weights for the two circles.
  void addOrientation(std::string_view id, const SharedCarrier& horizontal, const SharedCarrier& vertical,
                      const CellFunctions& functions) {
    add(id, Pattern{{{horizontal, functions}, {vertical, functions}}});
  }

  /// Adds three patterns of the same functions: in the horizontal circle, in the vertical circle, in both.
  void addOrientations(const std::array<std::string_view, 3>& ids, const SharedCarrier& horizontal,
                       const SharedCarrier& vertical, const CellFunctions& functions) {
    Pattern both{{{horizontal, functions}, {vertical, functions}}};
    MatrixXd gram = both.visibleGram(m_leftover);
    const Index own = functions.count();
    add(ids[0], Pattern{{{horizontal, functions}}}, gram.topLeftCorner(own, own));
    add(ids[1], Pattern{{{vertical, functions}}}, gram.bottomRightCorner(own, own));
    add(ids[2], std::move(both), std::move(gram));
  }

  std::vector<ShapeComponent> take() { return std::move(m_components); }

 private:
  static constexpr std::size_t mostGroups = 80;
  const Leftover& m_leftover;
  ErrorSource m_source = ErrorSource::Guideway;
  std::vector<ShapeComponent> m_components;

  void add(std::string_view id, Pattern pattern) {
    MatrixXd gram = pattern.visibleGram(m_leftover);
    add(id, std::move(pattern), std::move(gram));
  }

  /// Adds a pattern and scales it. `gram` belongs to the pattern before scaling.
  void add(std::string_view id, Pattern pattern, MatrixXd gram) {
    const double factor = pattern.normalise();
    gram *= factor * factor;
    if (gram.trace() < invisible * invisible) return;
    m_components.emplace_back(id, m_source, std::move(pattern), std::move(gram));
  }
};

VectorXd toUnit(const VectorXd& values) {
  const double least = values.minCoeff(), range = values.maxCoeff() - least;
  return range > 0 ? VectorXd((values.array() - least) / range) : VectorXd::Zero(values.size());
}

/// The orders from `first` to `last` that no effect of the catalogue has. Effects in `leftOut` do not count.
std::vector<int> ordersOutsideCatalogue(int ParameterTraits::*order, int first, int last,
                                        const std::vector<std::string>& leftOut) {
  std::vector<int> orders(static_cast<std::size_t>(last - first + 1));
  std::iota(orders.begin(), orders.end(), first);
  for (const Effect& effect : effectCatalogue())
    if (std::ranges::find(leftOut, effect.id) == leftOut.end())
      std::erase(orders, effect.parameters.front().traits.*order);
  return orders;
}

}  // namespace

ShapeComponent::ShapeComponent(std::string_view follows, ErrorSource source, Pattern pattern, MatrixXd gram)
    : m_follows(follows), m_source(source), m_pattern(std::move(pattern)), m_gram(std::move(gram)) {}

const std::vector<Width>& ShapeComponent::widths() const {
  static const std::vector<Width> widths = evenly({0.5, 1, 2, 4, 8, 16});
  return widths;
}

MatrixXd ShapeComponent::wholeColumns(const Leftover& leftover) const {
  const Index count = m_pattern.columns();
  MatrixXd columns(leftover.readings(), count);
  for (Index c = 0; c < count; ++c) columns.col(c) = m_pattern.times(VectorXd::Unit(count, c));
  return columns;
}

void ShapeComponent::fillProducts(const SharedProducts& with, Eigen::Ref<VectorXd> own) const {
  Index first = 0;
  for (const auto& part : m_pattern.parts) {
    const auto gather = [&] { return part.carrier->gathered(with.vector()); };
    const VectorXd& gathered = with.once(part.carrier.get(), gather);
    own.segment(first, part.functions.count()) = part.functions.products(gathered);
    first += part.functions.count();
  }
}

VectorXd ShapeComponent::times(const Leftover&, const VectorXd& weights) const {
  return m_pattern.times(weights);
}

void ShapeComponent::addTo(JointFitOptions&, const Leftover&, const VectorXd&, double) const {}

std::vector<ShapeComponent> shapeComponents(const Leftover& leftover, const Measurement& measurement,
                                            const JointFit& fit, const std::vector<std::string>& leftOut) {
  Surroundings all(leftover, measurement, fit);
  const SharedCarrier radial = all.alongGuideway(leftover.column(Unknown::Kind::Radius)),
                      offPlane = all.alongGuideway(leftover.column(ErrorTerm::PlaneOffset)),
                      slider = all.alongGuideway(leftover.column(Unknown::Kind::SliderZero));
  const VectorXd ofHorizontal = leftover.column(ErrorTerm::HorizontalJump),
                 ofVertical = leftover.column(ErrorTerm::VerticalJump);
  const SharedCarrier horizontal = all.ofInstrument(ofHorizontal), vertical = all.ofInstrument(ofVertical);
  ShapeMaker maker(leftover);
  const CellFunctions harmonics = harmonicsOf(all.s, 12);
  const std::vector<int> radialOrders = ordersOutsideCatalogue(&ParameterTraits::radialOrder, 2, 12, leftOut),
                         planeOrders = ordersOutsideCatalogue(&ParameterTraits::acrossOrder, 1, 8, leftOut);
  maker.addHarmonics(PHRASE_LATER("Phrase", "radius along the guideway"), radial, harmonics, radialOrders);
  maker.addHarmonics(PHRASE_LATER("Phrase", "guideway out of its plane"), offPlane, harmonics, planeOrders);
  maker.addHarmonics(PHRASE_LATER("Phrase", "slider readings along the scale"), slider, harmonics,
                     {2, 3, 4, 5, 6, 7, 8});
  const auto point = [&](Index i) { return all.rowOf(i).point; };
  maker.addGroups(PHRASE_LATER("Phrase", "radius from place to place, turning with the guideway"), radial,
                  all.visits, point);
  maker.addGroups(PHRASE_LATER("Phrase", "guideway out of its plane from place to place"), offPlane,
                  all.visits, point);
  maker.addGroups(PHRASE_LATER("Phrase", "slider readings from place to place"), slider, all.visits, point);
  const auto place = [&](Index i) { return std::pair(all.at(i).arc, all.rowOf(i).point); };
  maker.addGroups(PHRASE_LATER("Phrase", "radius from place to place in each position"), radial, all.visits,
                  place);
  maker.startSource(ErrorSource::Time);
  const CellFunctions waves = smooth(all.elapsed, wavesOf(all.rows->count()));
  maker.addOrientations({PHRASE_LATER("Phrase", "horizontal orientation varying with time"),
                         PHRASE_LATER("Phrase", "vertical orientation varying with time"),
                         PHRASE_LATER("Phrase", "orientation varying with time")},
                        horizontal, vertical, waves);
  maker.addOrientation(PHRASE_LATER("Phrase", "orientation settling with time"), horizontal, vertical,
                       settling(all.elapsed));
  std::vector<Index> slowest;
  for (Index wave = 0; wave < std::min<Index>(4, waves.count()); ++wave) slowest.push_back(wave);
  // A change of distance has the same sign in both positions; a plane offset changes its sign.
  const auto isTurned = [&](Index i) { return all.arcOf(i).axisDeg != 0; };
  maker.add(PHRASE_LATER("Phrase", "distance varying with time"),
            all.ofInstrument(leftover.column(ErrorTerm::PlaneOffset), isTurned), waves.chosen(slowest));
  maker.startSource(ErrorSource::Guideway);
  maker.add(PHRASE_LATER("Phrase", "slider readings along the scale"), slider, smooth(toUnit(all.s), 6));
  maker.startSource(ErrorSource::Instrument);
  const CellFunctions alongAzimuth = smooth(toUnit(all.a), 6), alongElevation = smooth(toUnit(all.e), 6);
  maker.add(PHRASE_LATER("Phrase", "horizontal readings varying with azimuth"), horizontal, alongAzimuth);
  maker.add(PHRASE_LATER("Phrase", "vertical readings varying with elevation"), vertical, alongElevation);
  maker.add(PHRASE_LATER("Phrase", "horizontal readings varying with elevation"), horizontal, alongElevation);
  maker.add(PHRASE_LATER("Phrase", "vertical readings varying with azimuth"), vertical, alongAzimuth);
  const auto isFace2 = [&](Index i) { return all.rowOf(i).face != 1; };
  maker.add(PHRASE_LATER("Phrase", "difference of the faces, horizontal"),
            all.ofInstrument(ofHorizontal, isFace2), alongElevation);
  maker.add(PHRASE_LATER("Phrase", "difference of the faces, vertical"),
            all.ofInstrument(ofVertical, isFace2), alongElevation);
  maker.startSource(ErrorSource::Time);
  const auto block = [&](Index i) {
    const Sighting& row = all.at(i).isZero ? all.arcOf(i).sightings.front() : all.rowOf(i);
    return std::tuple(all.at(i).arc, row.round, row.face);
  };
  maker.addGroups(PHRASE_LATER("Phrase", "horizontal orientation from round to round"), horizontal, all.rows,
                  block);
  maker.addGroups(PHRASE_LATER("Phrase", "vertical orientation from round to round"), vertical, all.rows,
                  block);
  return maker.take();
}

}  // namespace alidade

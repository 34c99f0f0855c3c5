#include "core/diagnosis/candidates/jump_components.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

const std::vector<Width>& jumpWidths() {
  static const std::vector<Width> widths = evenly({0.3, 1});
  return widths;
}

const std::vector<Width>& usualAndFarWiderJumpWidths() {
  static const std::vector<Width> widths = andFarWider(jumpWidths(), 30);
  return widths;
}

JumpComponent::JumpComponent(std::shared_ptr<const JumpColumns> columns, std::size_t index,
                             Eigen::Matrix2d gram, std::optional<std::size_t> onlyRow)
    : m_columns(std::move(columns)), m_index(index), m_gram(std::move(gram)), m_onlyRow(onlyRow) {}

std::string_view JumpComponent::id() const {
  return jumpId;
}

const std::vector<Width>& JumpComponent::widths() const {
  return jumpWidths();
}

MatrixXd JumpComponent::wholeColumns(const Leftover& leftover) const {
  MatrixXd columns(leftover.readings(), 2);
  columns << leftover.column(ErrorTerm::HorizontalJump), leftover.column(ErrorTerm::VerticalJump);
  for (Index i = 0; i < columns.rows(); ++i)
    if (!moment().actsOn(leftover.reading(i).sequence)) columns.row(i).setZero();
  return columns * plausibleJump;
}

void JumpComponent::fillProducts(const SharedProducts& with, Eigen::Ref<VectorXd> own) const {
  const VectorXd& ofAll =
      with.once(m_columns.get(), [&] { return m_columns->products(with.vector()).reshaped().eval(); });
  own = ofAll.segment<2>(2 * static_cast<Index>(m_index));
}

/// The far wider width counts only once the usual widths detect a jump. They detect a jump however far beyond
/// them.
Gain JumpComponent::gain(const TurnedColumns& columns, double variance) const {
  constexpr double shows = 10;  // ln Bayes factor of a detected jump
  const Gain usual = Component::gain(columns, variance);
  return usual.log > shows ? gainOf(usualAndFarWiderJumpWidths(), columns, variance) : usual;
}

/// The visible part of a jump indicates its size, and thereby the prior width of its invisible part. The
/// result is the rms of the widths, weighted by the likelihood of the larger weight, but at least this
/// weight.
double JumpComponent::widthOfFit(double, const VectorXd& weights) const {
  const double seen = weights.cwiseAbs().maxCoeff();
  double square = 0, all = 0;
  for (const Width& width : widths()) {
    const double chance = std::exp(width.logChance - 0.5 * std::pow(seen / width.sigma, 2)) / width.sigma;
    square += chance * width.sigma * width.sigma;
    all += chance;
  }
  return std::max(seen, all > 0 ? std::sqrt(square / all) : 0);
}

void JumpComponent::addTo(JointFitOptions& model, const Leftover&, const VectorXd&, double width) const {
  const double sigma = width * plausibleJump;
  model.jumpBefore = moment().first;
  if (moment().end != JumpMoment::never) model.jumpEnd = moment().end;
  model.terms.push_back({ErrorTerm::HorizontalJump, sigma});
  model.terms.push_back({ErrorTerm::VerticalJump, sigma});
}

namespace {

/// Returns `Sighting::sequence` of the first row at or after `order`.
std::size_t firstRowFrom(std::size_t order, const Measurement& measurement) {
  std::size_t first = measurement.rows;
  for (const ArcMeasurement& arc : measurement.arcs)
    for (const Sighting& sighting : arc.sightings)
      if (!sighting.isZero && sighting.order >= order) first = std::min(first, sighting.sequence);
  return first;
}

}  // namespace

std::vector<CauseParameter> JumpComponent::parameters(const GapModel& after) const {
  return {
      estimatedParameter(after, PHRASE_LATER("Phrase", "horizontal step"), ErrorTerm::HorizontalJump,
                         "arcsec"),
      estimatedParameter(after, PHRASE_LATER("Phrase", "vertical step"), ErrorTerm::VerticalJump, "arcsec"),
      {"before row", static_cast<double>(firstRowFrom(moment().first, *after.measurement)) + 1, 0, "-"}};
}

namespace {

/// Orders of the rows of one arc, and of the sightings of its zero before the first row; both ascending.
struct ArcInOrder {
  std::vector<std::size_t> rows, zeros;
  std::size_t last = 0;  ///< largest order of rows and zeros

  std::size_t begin() const { return zeros.empty() ? rows.front() : std::min(zeros.front(), rows.front()); }
};
using ArcsInOrder = std::map<std::size_t, ArcInOrder>;

void sortEachOnce(std::vector<std::size_t>& orders) {
  std::ranges::sort(orders);
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
}

ArcsInOrder arcsInOrder(const Leftover& leftover) {
  ArcsInOrder arcs;
  for (Index i = 0; i < leftover.readings(); ++i) {
    ArcInOrder& arc = arcs[leftover.reading(i).arc];
    const std::size_t order = leftover.reading(i).sequence;
    (leftover.reading(i).isZero ? arc.zeros : arc.rows).push_back(order);
    arc.last = std::max(arc.last, order);
  }
  std::erase_if(arcs, [](const auto& arc) { return arc.second.rows.empty(); });
  for (auto& [index, arc] : arcs) {
    sortEachOnce(arc.rows);
    sortEachOnce(arc.zeros);
    std::erase_if(arc.zeros, [&rows = arc.rows](std::size_t order) { return order > rows.front(); });
  }
  return arcs;
}

/// Whether all positions have a common zero mark in one circle or both. Differences of zeros then show jumps.
bool haveCommonZeros(const Leftover& leftover) {
  return std::ranges::any_of(leftover.equations().unknowns, [](const Unknown& unknown) {
    return unknown.isPointingZero() && unknown.arc == Unknown::everyArc;
  });
}

/// End of a jump that lasts until the next position begins.
std::size_t endOf(const ArcsInOrder& arcs, ArcsInOrder::const_iterator arc) {
  const auto next = std::next(arc);
  return next == arcs.end() ? JumpMoment::never : next->second.begin();
}

std::set<std::size_t> rowsAloneInTheirVisit(const Leftover& leftover) {
  std::set<std::size_t> rows;
  for (Index v = 0; v < leftover.visits(); ++v)
    if (const Leftover::Run visit = leftover.readingsOf(v);
        visit.length() == 2 && !leftover.reading(visit.first).isZero)
      rows.insert(leftover.reading(visit.first).sequence);
  return rows;
}

/// Finds the row that a jump separates from all rows that could confirm the jump. The row is the only one of
/// its visit: only the condition between its two circles shows the jump.
class ShownByOneRow {
 public:
  /// `arcs` must outlive this object.
  ShownByOneRow(const Leftover& leftover, const ArcsInOrder& arcs)
      : m_alone(rowsAloneInTheirVisit(leftover)), m_arcs(arcs), m_isClosed(leftover.equations().isClosed()) {}

  std::optional<std::size_t> of(const JumpMoment& moment) const {
    for (auto arc = m_arcs.begin(); arc != m_arcs.end(); ++arc) {
      const std::vector<std::size_t>& rows = arc->second.rows;
      if (rows.size() < 2) continue;
      // Closures between the positions show a jump that moves a position as a whole.
      const bool endsHere = moment.end == endOf(m_arcs, arc);
      if (moment.first == rows.back() && (endsHere || !m_isClosed) && m_alone.contains(rows.back()))
        return rows.back();
      if (moment.first == rows[1] && !m_isClosed && m_alone.contains(rows.front())) return rows.front();
    }
    return std::nullopt;
  }

 private:
  std::set<std::size_t> m_alone;
  const ArcsInOrder& m_arcs;
  bool m_isClosed;
};

std::vector<JumpComponent> componentsOf(const Leftover& leftover, std::vector<JumpMoment> moments,
                                        const ShownByOneRow& shown) {
  const auto columns = std::make_shared<const JumpColumns>(leftover, std::move(moments), plausibleJump);
  const std::vector<Eigen::Matrix2d> grams = columns->visibleGrams(leftover);
  std::vector<JumpComponent> components;
  for (std::size_t m = 0; m < grams.size(); ++m)
    components.emplace_back(columns, m, grams[m], shown.of(columns->moments()[m]));
  return components;
}

/// Returns all moments, or every n-th moment of a long session.
std::vector<JumpMoment> someOf(const std::vector<JumpMoment>& moments) {
  constexpr std::size_t most = 400;
  const std::size_t stride = moments.size() / most + 1;
  std::vector<JumpMoment> some;
  for (std::size_t m = 0; m < moments.size(); m += stride) some.push_back(moments[m]);
  return some;
}

}  // namespace

std::vector<JumpComponent> jumpComponents(const Leftover& leftover) {
  const bool isClosed = leftover.equations().isClosed();
  const ArcsInOrder arcs = arcsInOrder(leftover);
  const bool areCommon = haveCommonZeros(leftover);
  std::vector<JumpMoment> lasting, ofOnePosition;
  for (auto arc = arcs.begin(); arc != arcs.end(); ++arc) {
    const std::vector<std::size_t>&rows = arc->second.rows, &zeros = arc->second.zeros;
    if (areCommon && arc != arcs.begin() && !zeros.empty()) lasting.push_back({zeros.front()});
    for (const std::size_t row : rows) {
      if (row == rows.front() && (isClosed || arc == arcs.begin())) continue;
      const std::size_t end = endOf(arcs, arc);
      const bool mayEnd = isClosed && end != JumpMoment::never;
      if (mayEnd) ofOnePosition.push_back({row, end});
      // Without a common zero mark, the zero of the next position absorbs a lasting jump.
      if (!mayEnd || areCommon || zeros.empty()) lasting.push_back({row});
    }
  }
  if (lasting.size() + ofOnePosition.size() < 2) return {};
  const ShownByOneRow shown(leftover, arcs);
  std::vector<JumpComponent> components = componentsOf(leftover, someOf(lasting), shown);
  std::ranges::move(componentsOf(leftover, someOf(ofOnePosition), shown), std::back_inserter(components));
  return components;
}

std::vector<JumpComponent> wrongZeros(const Leftover& leftover) {
  if (!leftover.equations().isClosed()) return {};
  const ArcsInOrder arcs = arcsInOrder(leftover);
  const bool areCommon = haveCommonZeros(leftover);
  std::vector<JumpComponent> components;
  const auto add = [&](std::size_t arc, const JumpMoment& moment) {
    std::vector<JumpComponent> own = componentsOf(leftover, {moment}, {leftover, arcs});
    own.front().setWrongZeroArc(arc);
    components.push_back(std::move(own.front()));
  };
  for (auto arc = arcs.begin(); arc != arcs.end(); ++arc) {
    const std::vector<std::size_t>&rows = arc->second.rows, &zeros = arc->second.zeros;
    const bool isLast = std::next(arc) == arcs.end();
    add(arc->first, {rows.front(), isLast ? arc->second.last + 1 : endOf(arcs, arc)});
    if (zeros.empty() || !areCommon) continue;
    if (!isLast) add(arc->first, {rows.front()});
    if (arc != arcs.begin()) add(arc->first, {zeros.front(), rows.front()});
  }
  return components;
}

}  // namespace alidade

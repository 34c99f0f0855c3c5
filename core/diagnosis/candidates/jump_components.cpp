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

/// Jumps of any size show at the usual widths, too, and most moments show none.
Gain JumpComponent::gain(const TurnedColumns& columns, double variance) const {
  constexpr double shows = 10;  // natural logarithm
  const Gain usual = Component::gain(columns, variance);
  return usual.log > shows ? gainOf(usualAndFarWiderJumpWidths(), columns, variance) : usual;
}

/// What shows of a knock tells how hard it was, and so how far the part may go that does not show: the root
/// of the mean square of the widths, each as likely as it makes the larger of the two steps.
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

std::vector<CauseParameter> JumpComponent::parameters(const GapModel& after) const {
  return {
      estimatedParameter(after, PHRASE_LATER("Phrase", "horizontal step"), ErrorTerm::HorizontalJump,
                         "arcsec"),
      estimatedParameter(after, PHRASE_LATER("Phrase", "vertical step"), ErrorTerm::VerticalJump, "arcsec"),
      {"before row", static_cast<double>(moment().first) + 1, 0, "-"}};
}

namespace {

/// Sequences of the rows of each arc, ascending.
using RowsOfArcs = std::map<std::size_t, std::vector<std::size_t>>;

RowsOfArcs rowsOfArcs(const Leftover& leftover) {
  RowsOfArcs arcs;
  for (Index i = 0; i < leftover.readings(); ++i)
    arcs[leftover.reading(i).arc].push_back(leftover.reading(i).sequence);
  for (auto& [arc, rows] : arcs) {
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  return arcs;
}

std::set<std::size_t> rowsAloneInTheirVisit(const Leftover& leftover) {
  std::set<std::size_t> rows;
  for (Index v = 0; v < leftover.visits(); ++v)
    if (const Leftover::Run visit = leftover.readingsOf(v); visit.length() == 2)
      rows.insert(leftover.reading(visit.first).sequence);
  return rows;
}

/// Finds the row, alone in its visit, that a jump parts from all that could show the rest of it: what could
/// be seen of the jump is the one condition between the two circles of that row.
class ShownByOneRow {
 public:
  /// `arcs` have to live as long.
  ShownByOneRow(const Leftover& leftover, const RowsOfArcs& arcs)
      : m_alone(rowsAloneInTheirVisit(leftover)), m_arcs(arcs), m_isClosed(leftover.equations().isClosed()) {}

  std::optional<std::size_t> of(const JumpMoment& moment) const {
    for (const auto& [arc, rows] : m_arcs) {
      if (rows.size() < 2) continue;
      // Where the positions are held against each other they show what moves a position as a whole.
      const bool endsHere = moment.end == rows.back() + 1 || arc == m_arcs.rbegin()->first;
      if (moment.first == rows.back() && (endsHere || !m_isClosed) && m_alone.contains(rows.back()))
        return rows.back();
      if (moment.first == rows[1] && !m_isClosed && m_alone.contains(rows.front())) return rows.front();
    }
    return std::nullopt;
  }

 private:
  std::set<std::size_t> m_alone;
  const RowsOfArcs& m_arcs;
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

/// As many as are looked at.
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
  const RowsOfArcs arcs = rowsOfArcs(leftover);
  std::vector<JumpMoment> lasting, ofOnePosition;
  for (auto arc = arcs.begin(); arc != arcs.end(); ++arc) {
    const bool isLast = std::next(arc) == arcs.end();
    for (const std::size_t row : arc->second) {
      if (row == arc->second.front() && (isClosed || arc == arcs.begin())) continue;
      lasting.push_back({row});
      if (isClosed && !isLast) ofOnePosition.push_back({row, arc->second.back() + 1});
    }
  }
  if (lasting.size() < 2) return {};
  const ShownByOneRow shown(leftover, arcs);
  std::vector<JumpComponent> components = componentsOf(leftover, someOf(lasting), shown);
  std::ranges::move(componentsOf(leftover, someOf(ofOnePosition), shown), std::back_inserter(components));
  return components;
}

std::vector<JumpComponent> zeroSlips(const Leftover& leftover) {
  if (!leftover.equations().isClosed()) return {};
  const RowsOfArcs arcs = rowsOfArcs(leftover);
  std::vector<JumpMoment> moments;
  for (const auto& [arc, rows] : arcs) moments.push_back({rows.front(), rows.back() + 1});
  std::vector<JumpComponent> slips = componentsOf(leftover, std::move(moments), {leftover, arcs});
  for (auto slip = slips.begin(); const auto& [arc, rows] : arcs) (slip++)->setSlippedArc(arc);
  return slips;
}

}  // namespace alidade

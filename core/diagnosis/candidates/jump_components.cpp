#include "core/diagnosis/candidates/jump_components.h"

#include <algorithm>
#include <map>
#include <utility>

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
    if (leftover.reading(i).sequence < moment()) columns.row(i).setZero();
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

void JumpComponent::addTo(JointFitOptions& model, const Leftover&, const VectorXd&, double width) const {
  const double sigma = width * plausibleJump;
  model.jumpBefore = moment();
  model.terms.push_back({ErrorTerm::HorizontalJump, sigma});
  model.terms.push_back({ErrorTerm::VerticalJump, sigma});
}

std::vector<CauseParameter> JumpComponent::parameters(const GapModel& after) const {
  return {estimatedParameter(after, "horizontal step", ErrorTerm::HorizontalJump, "arcsec"),
          estimatedParameter(after, "vertical step", ErrorTerm::VerticalJump, "arcsec"),
          {"before row", static_cast<double>(moment()) + 1, 0, "-"}};
}

namespace {

void sortAsSet(std::vector<std::size_t>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Moments whose jump parts a row alone in its visit from the rest of its position, as its first or its last:
/// all that could be seen of it is the one condition between the two circles of that row.
std::map<std::size_t, std::size_t> rowsThatAloneShow(const Leftover& leftover) {
  std::map<std::size_t, std::vector<std::size_t>> rowsOfArc;
  std::vector<std::size_t> alone;
  for (Index v = 0; v < leftover.visits(); ++v) {
    const Leftover::Run visit = leftover.readingsOf(v);
    for (Index i = visit.first; i < visit.end; ++i) {
      const LinearReading& reading = leftover.reading(i);
      rowsOfArc[reading.arc].push_back(reading.sequence);
      if (visit.length() == 2) alone.push_back(reading.sequence);
    }
  }
  const auto isAlone = [&](std::size_t row) { return std::ranges::find(alone, row) != alone.end(); };
  std::map<std::size_t, std::size_t> rows;
  for (auto& [arc, own] : rowsOfArc) {
    sortAsSet(own);
    if (own.size() < 2) continue;
    if (isAlone(own.back())) rows.emplace(own.back(), own.back());
    if (isAlone(own.front())) rows.emplace(own[1], own.front());
  }
  return rows;
}

}  // namespace

std::vector<JumpComponent> jumpComponents(const Leftover& leftover) {
  constexpr std::size_t mostMoments = 400;
  std::vector<std::size_t> rows;
  for (Index i = 0; i < leftover.readings(); ++i) rows.push_back(leftover.reading(i).sequence);
  sortAsSet(rows);
  if (rows.size() < 3) return {};
  rows.erase(rows.begin());  // before the first row there is no jump
  const std::map<std::size_t, std::size_t> shownByOne = rowsThatAloneShow(leftover);
  const std::size_t stride = rows.size() / mostMoments + 1;
  std::vector<std::size_t> moments;
  for (std::size_t m = 0; m < rows.size(); m += stride) moments.push_back(rows[m]);
  const auto columns = std::make_shared<const JumpColumns>(leftover, std::move(moments), plausibleJump);
  const std::vector<Eigen::Matrix2d> grams = columns->visibleGrams(leftover);
  std::vector<JumpComponent> components;
  for (std::size_t m = 0; m < grams.size(); ++m) {
    const auto only = shownByOne.find(columns->moments()[m]);
    components.emplace_back(columns, m, grams[m],
                            only == shownByOne.end() ? std::nullopt : std::optional(only->second));
  }
  return components;
}

}  // namespace alidade

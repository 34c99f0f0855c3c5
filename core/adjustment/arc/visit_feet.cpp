#include "core/adjustment/arc/visit_feet.h"

#include <cmath>

namespace alidade {

namespace {

using Block = VisitFeet::Block;

constexpr double nearlyHalf = 3;  // rad; beyond it, a slider's residual may have to be wrapped
constexpr std::size_t columns = ArcEquations::columns, sliderColumn = 3;

template <typename Mask>
[[gnu::always_inline]] inline bool areAll(const Mask& mask) {
  bool all = true;
  for (std::size_t i = 0; i < eight; ++i) all &= mask[i] != 0;
  return all;
}

/// Computes the residuals at the current feet. False if one is too large for the series.
[[gnu::always_inline]] inline bool look(Block& b, const ArcView& view, const Circle& circle) {
  const auto residuals = lookFrom<Eight>(b.foot, view, circle, b.tanA, b.tanE);
  const auto isSmall = [](const Ratio<Eight>& ratio) {
    return magnitude<Eight>(ratio.above) < smallAngle * ratio.below;
  };
  if (!areAll(isSmall(residuals.a) & isSmall(residuals.e))) return false;
  b.foot.left = {angleOfSmall<Eight>(residuals.a), angleOfSmall<Eight>(residuals.e)};
  return true;
}

/// `footPoint` for a block, from the current feet; false if series do not suffice or a slider's residual may
/// have to be wrapped.
[[gnu::always_inline]] inline bool convergeTogether(Block& b, const ArcView& view, const Circle& circle) {
  if (!areAll(magnitude<Eight>(b.foot.sliderLeft) < nearlyHalf) || !look(b, view, circle)) return false;
  Eight before{};
  for (int i = 0; i < mostFootSteps; ++i) {
    const Direction<Eight> along = alongArc<Eight>(view, circle.radius, b.foot);
    const Eight step = footStep<Eight>(view, circle.radius, b.foot, along, b.rows, b.sliderRows);
    const Eight size = magnitude<Eight>(step);
    if (!areAll(size < smallAngle)) return false;
    turnBySmall<Eight>(b.foot, step);
    b.foot.sliderLeft -= view.turn * step * b.sliderRows;
    if (areAll(isLastFootStep<Eight>(size, before))) {
      followLastStep<Eight>(b.foot, view, along, step);
      return true;
    }
    if (!look(b, view, circle)) return false;
    before = size;
  }
  return true;
}

/// One row of derivatives for each kind of reading, after subtracting the component along the arc.
struct Rows {
  Eight along[3];  ///< ∂/∂φ, of unit length over all readings of the visit
  Eight reduced[3][columns];
};

template <bool hasSlider>
[[gnu::always_inline]] inline void fill(Rows& rows, const Block& b, const ArcView& view, double radius) {
  constexpr std::size_t kinds = hasSlider ? 3 : 2;
  const Whitening& w = view.whitening;
  const Foot<Eight>& foot = b.foot;
  const Direction<Eight> along = alongArc<Eight>(view, radius, foot);
  const Eight aX = w.horizontal * foot.aX, eX = w.vertical * foot.eX, eY = w.vertical * foot.eY;
  const Eight none{};
  const Eight slider = w.slider * b.sliderRows;
  const Eight derivatives[3][columns] = {
      {aX, none, aX * foot.cosine, none, none - w.horizontal, none, w.horizontal * foot.aL},
      {eX, eY, eX * foot.cosine + eY * foot.sine, none, none, none + w.vertical, w.vertical * foot.eL},
      {none, none, none, slider, none, none, none}};
  const Eight counts[3] = {b.rows, b.rows, b.sliderRows};
  rows.along[0] = along.a;
  rows.along[1] = along.e;
  rows.along[2] = slider * view.turn;
  Eight square{};
  for (std::size_t k = 0; k < kinds; ++k) square += counts[k] * rows.along[k] * rows.along[k];
  const Eight perLength = 1 / squareRoot<Eight>(square);
  for (std::size_t k = 0; k < kinds; ++k) rows.along[k] *= perLength;
  for (std::size_t i = 0; i < columns; ++i) {
    Eight share{};
    for (std::size_t k = 0; k < kinds; ++k) share += rows.along[k] * counts[k] * derivatives[k][i];
    for (std::size_t k = 0; k < kinds; ++k) rows.reduced[k][i] = derivatives[k][i] - rows.along[k] * share;
  }
}

struct Sums {
  Eight normal[ArcEquations::estimated][columns] = {};  ///< from the diagonal on
  Eight rightSide[ArcEquations::estimated] = {};
  Eight chiSquare = {};
};

template <bool hasSlider>
[[gnu::always_inline]] inline void add(Sums& sums, const Block& b, const ArcView& view, double radius) {
  constexpr std::size_t kinds = hasSlider ? 3 : 2;
  Rows rows;
  fill<hasSlider>(rows, b, view, radius);
  const Whitening& w = view.whitening;
  const Eight left[3] = {w.horizontal * b.foot.left.a, w.vertical * b.foot.left.e,
                         w.slider * b.foot.sliderLeft};
  const Eight counts[3] = {b.counts, b.counts, b.sliderCounts};
  for (std::size_t k = 0; k < kinds; ++k) {
    for (std::size_t i = 0; i < ArcEquations::estimated; ++i) {
      if (!hasSlider && i == sliderColumn) continue;
      const Eight weighted = counts[k] * rows.reduced[k][i];
      for (std::size_t j = i; j < columns; ++j)
        if (hasSlider || j != sliderColumn) sums.normal[i][j] += weighted * rows.reduced[k][j];
      sums.rightSide[i] += weighted * left[k];
    }
    sums.chiSquare += counts[k] * left[k] * left[k];
  }
}

[[gnu::always_inline]] inline double total(const Eight& values) {
  double sum = 0;
  for (std::size_t i = 0; i < eight; ++i) sum += values[i];
  return sum;
}

template <bool hasSlider>
[[gnu::always_inline]] inline void addAll(const std::vector<Block>& blocks, const ArcView& view,
                                          double radius, ArcEquations& equations) {
  Sums sums;
  for (const Block& block : blocks) add<hasSlider>(sums, block, view, radius);
  for (std::size_t i = 0; i < ArcEquations::estimated; ++i) {
    for (std::size_t j = i; j < columns; ++j) {
      equations.normal[i][j] = total(sums.normal[i][j]);
      if (j < ArcEquations::estimated) equations.normal[j][i] = equations.normal[i][j];
    }
    equations.rightSide[i] = total(sums.rightSide[i]);
  }
  equations.chiSquare = total(sums.chiSquare);
}

// The entry points.

ALIDADE_WIDE void startInPlane(Block& block, const ArcView& view, const Circle& circle) {
  turnTo<Eight>(block.foot, sightedAlong<Eight>(view, block.tanA, block.tanE), circle);
}

/// False if the block must converge visit by visit; the directions of its feet are then unchanged.
ALIDADE_WIDE bool converge(Block& block, const ArcView& view, const Circle& circle) {
  const Eight cosine = block.foot.cosine, sine = block.foot.sine;
  if (convergeTogether(block, view, circle)) return true;
  block.foot.cosine = cosine;
  block.foot.sine = sine;
  return false;
}

ALIDADE_WIDE void addUp(const std::vector<Block>& blocks, const ArcView& view, double radius, bool hasSlider,
                        ArcEquations& equations) {
  hasSlider ? addAll<true>(blocks, view, radius, equations) : addAll<false>(blocks, view, radius, equations);
}

struct alignas(sizeof(Eight)) ReliabilityOfEight {
  Eight redundancy[3], rate[3];
};

ALIDADE_WIDE void rely(const Block& block, const ArcView& view, double radius,
                       const VisitFeet::Cofactor& cofactor,
                       const std::array<double, ArcEquations::estimated>& requested,
                       ReliabilityOfEight& result) {
  Rows rows;
  fill<true>(rows, block, view, radius);
  for (std::size_t k = 0; k < 3; ++k) {
    Eight redundancy = 1 - rows.along[k] * rows.along[k], rate{};
    for (std::size_t i = 0; i < ArcEquations::estimated; ++i) {
      Eight turned{};
      for (std::size_t j = 0; j < ArcEquations::estimated; ++j) turned += cofactor[i][j] * rows.reduced[k][j];
      redundancy -= rows.reduced[k][i] * turned;
      rate += rows.reduced[k][i] * requested[i];
    }
    result.redundancy[k] = redundancy;
    result.rate[k] = rate;
  }
}

VisitReading readingIn(const Block& block, std::size_t i) {
  VisitReading reading;
  reading.tanA = block.tanA[i];
  reading.tanE = block.tanE[i];
  reading.rows = block.rows[i];
  if (block.sliderRows[i] != 0) reading.slider = block.slider[i];
  return reading;
}

}  // namespace

void VisitFeet::add(const VisitReading& visit) {
  const std::size_t first = m_size++ % eight;
  if (first == 0) m_blocks.emplace_back();
  Block& b = m_blocks.back();
  for (std::size_t i = first; i < eight; ++i) {
    b.tanA[i] = visit.tanA;
    b.tanE[i] = visit.tanE;
    b.rows[i] = visit.rows;
    b.slider[i] = visit.slider.value_or(0);
    b.sliderRows[i] = visit.slider ? 1 : 0;
  }
  b.counts[first] = b.rows[first];
  b.sliderCounts[first] = b.sliderRows[first];
  m_hasSlider = m_hasSlider || visit.slider;
}

VisitReading VisitFeet::reading(std::size_t visit) const {
  return readingIn(m_blocks[visit / eight], visit % eight);
}

/// Computes the residuals of the sliders at the current feet.
void VisitFeet::lookAtSliders(Block& block, const ArcUnknowns& unknowns) const {
  for (std::size_t i = 0; i < eight; ++i) {
    if (block.sliderRows[i] == 0) continue;
    const double phi = std::atan2(block.foot.sine[i], block.foot.cosine[i]);
    const double left = block.slider[i] - unknowns.sliderZero - m_view.turn * phi;
    block.foot.sliderLeft[i] = wrapped(Angle::fromRadians(left)).radians();
  }
}

ArcEquations VisitFeet::converge(const ArcUnknowns& unknowns, From from) {
  const double zeroMoved = unknowns.sliderZero - m_unknowns.sliderZero;
  for (Block& block : m_blocks) {
    if (from == From::Plane) {
      startInPlane(block, m_view, unknowns.circle);
      if (m_hasSlider) lookAtSliders(block, unknowns);
    } else if (m_hasSlider) {
      for (std::size_t i = 0; i < eight; ++i) block.foot.sliderLeft[i] -= zeroMoved * block.sliderRows[i];
    }
    if (!alidade::converge(block, m_view, unknowns.circle)) convergeSeparately(block, unknowns, from);
  }
  m_unknowns = unknowns;
  ArcEquations equations;
  addUp(m_blocks, m_view, unknowns.circle.radius, m_hasSlider, equations);
  return equations;
}

void VisitFeet::convergeSeparately(Block& block, const ArcUnknowns& unknowns, From from) const {
  Foot<Eight>& all = block.foot;
  for (std::size_t i = 0; i < eight; ++i) {
    const VisitReading visit = readingIn(block, i);
    FootPoint foot;
    foot.cosine = all.cosine[i];
    foot.sine = all.sine[i];
    foot.phi = std::atan2(foot.sine, foot.cosine);
    foot =
        from == From::Plane ? footPoint(m_view, unknowns, visit) : footPoint(m_view, unknowns, visit, foot);
    all.cosine[i] = foot.cosine;
    all.sine[i] = foot.sine;
    all.left.a[i] = foot.left.a;
    all.left.e[i] = foot.left.e;
    all.sliderLeft[i] = foot.sliderLeft;
    all.aX[i] = foot.aX;
    all.aL[i] = foot.aL;
    all.eX[i] = foot.eX;
    all.eY[i] = foot.eY;
    all.eL[i] = foot.eL;
  }
}

double VisitFeet::arcAngle(std::size_t visit) const {
  const Foot<Eight>& foot = m_blocks[visit / eight].foot;
  return std::atan2(foot.sine[visit % eight], foot.cosine[visit % eight]);
}

Direction<double> VisitFeet::left(std::size_t visit) const {
  const Direction<Eight>& left = m_blocks[visit / eight].foot.left;
  return {left.a[visit % eight], left.e[visit % eight]};
}

double VisitFeet::sliderLeft(std::size_t visit) const {
  return m_blocks[visit / eight].foot.sliderLeft[visit % eight];
}

std::array<VisitReliability, eight> VisitFeet::reliabilityOf(
    std::size_t block, const Cofactor& cofactor,
    const std::array<double, ArcEquations::estimated>& requested) const {
  ReliabilityOfEight together;
  rely(m_blocks[block], m_view, m_unknowns.circle.radius, cofactor, requested, together);
  std::array<VisitReliability, eight> apart;
  for (std::size_t i = 0; i < eight; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      apart[i].redundancy[k] = together.redundancy[k][i];
      apart[i].rate[k] = together.rate[k][i];
    }
  return apart;
}

}  // namespace alidade

#include "core/adjustment/arc/visit_feet.h"

#include <cmath>

namespace alidade {

namespace {

using Block = VisitFeet::Block;

constexpr double small = 1e-3;    // rad; the series are exact to rounding up to there
constexpr double nearlyHalf = 3;  // rad; beyond, a slider's residual may have to be wrapped
constexpr std::size_t columns = ArcEquations::estimated + ArcEquations::considered;
constexpr std::size_t sliderColumn = 3;

/// What all visits have in common.
struct Common {
  double l, x, y, radius, turn;
  double horizontal, vertical, slider;  // whitening
  bool isExact;

  Common(const ArcView& view, const ArcUnknowns& unknowns)
      : l(view.distance),
        x(unknowns.circle.x),
        y(unknowns.circle.y),
        radius(unknowns.circle.radius),
        turn(view.turn),
        horizontal(view.whitening.horizontal),
        vertical(view.whitening.vertical),
        slider(view.whitening.slider),
        isExact(view.relation == VerticalAngleRelation::Exact) {}
};

template <typename T>
[[gnu::always_inline]] inline T sizeOf(const T& x) {
  return x < 0 ? -x : x;
}

[[gnu::always_inline]] inline Eight root(const Eight& x) {
  Eight result;
  for (std::size_t i = 0; i < eight; ++i) result[i] = __builtin_sqrt(x[i]);
  return result;
}

template <typename Mask>
[[gnu::always_inline]] inline bool areAll(const Mask& mask) {
  bool all = true;
  for (std::size_t i = 0; i < eight; ++i) all &= mask[i] != 0;
  return all;
}

/// The angle whose sine and cosine are as `above` to `below`.
[[gnu::always_inline]] inline Eight smallAngle(const Eight& above, const Eight& below) {
  const Eight t = above / below, tt = t * t;
  return t * (1 - tt * (1.0 / 3 - tt * (1.0 / 5)));
}

[[gnu::always_inline]] inline void stand(Block& b, const Common& c) {
  const Eight sightedX = c.l * b.tanA.at;
  const Eight ground = c.isExact ? root(sightedX * sightedX + c.l * c.l) : Eight{} + c.l;
  const Eight x = sightedX - c.x, y = ground * b.tanE.at - c.y;
  const Eight length = root(x * x + y * y);
  b.cosine.at = length > 0 ? x / length : Eight{} + 1;
  b.sine.at = length > 0 ? y / length : Eight{};
}

/// Residuals and derivatives where the visits stand; false where a residual is not small.
[[gnu::always_inline]] inline bool look(Block& b, const Common& c) {
  const Eight x = c.x + c.radius * b.cosine.at, y = c.y + c.radius * b.sine.at;
  const Eight square = x * x + c.l * c.l;
  const Eight aboveA = b.tanA.at * c.l - x, belowA = c.l + x * b.tanA.at;
  const Eight perSquare = 1 / square;
  b.aX.at = c.l * perSquare;
  b.aL.at = -x * perSquare;
  const Eight ground = c.isExact ? root(square) : Eight{} + c.l;
  const Eight aboveE = b.tanE.at * ground - y, belowE = ground + y * b.tanE.at;
  if (!areAll((sizeOf(aboveA) < small * belowA) & (sizeOf(aboveE) < small * belowE))) return false;
  b.leftA.at = smallAngle(aboveA, belowA);
  b.leftE.at = smallAngle(aboveE, belowE);
  const Eight perBoth = 1 / (ground * (ground * ground + y * y));
  const Eight perGround = -y * perBoth;
  b.eY.at = ground * ground * perBoth;
  b.eX.at = c.isExact ? perGround * x : Eight{};
  b.eL.at = perGround * c.l;
  return true;
}

/// ∂(a, e)/∂φ, in σ.
struct Along {
  Eight a, e;
};

[[gnu::always_inline]] inline Along alongArc(const Block& b, const Common& c) {
  return {-c.horizontal * c.radius * b.sine.at * b.aX.at,
          c.vertical * c.radius * (b.cosine.at * b.eY.at - b.sine.at * b.eX.at)};
}

/// As `footPoint`, from where the visits stand; false where that takes more than series, or a slider's
/// residual may have to be wrapped.
[[gnu::always_inline]] inline bool settleTogether(Block& b, const Common& c) {
  constexpr int maximumIterations = 25;
  constexpr double smallestStep = 1e-14, near = 1e-10;
  if (!areAll(sizeOf(b.sliderLeft.at) < nearlyHalf) || !look(b, c)) return false;
  const Eight sliderWeight = c.slider * c.slider * b.sliderRows.at;
  Eight before{};
  for (int i = 0; i < maximumIterations; ++i) {
    const Along along = alongArc(b, c);
    const Eight left = b.rows.at * (along.a * c.horizontal * b.leftA.at + along.e * c.vertical * b.leftE.at) +
                       c.turn * sliderWeight * b.sliderLeft.at;
    const Eight square = b.rows.at * (along.a * along.a + along.e * along.e) + sliderWeight;
    const Eight added =
        b.rows.at * c.radius *
        (c.horizontal * c.horizontal * b.leftA.at * b.cosine.at * b.aX.at +
         c.vertical * c.vertical * b.leftE.at * (b.sine.at * b.eY.at + b.cosine.at * b.eX.at));
    const Eight step = left / (square + (sizeOf(added) < 0.1 * square ? added : Eight{}));
    const Eight size = sizeOf(step);
    if (!areAll(size < small)) return false;
    const Eight ss = step * step;
    const Eight cosine = 1 - ss * (1.0 / 2 - ss * (1.0 / 24));
    const Eight sine = step * (1 - ss * (1.0 / 6 - ss * (1.0 / 120)));
    const Eight turned = b.cosine.at * cosine - b.sine.at * sine;
    b.sine.at = b.cosine.at * sine + b.sine.at * cosine;
    b.cosine.at = turned;
    b.sliderLeft.at -= c.turn * step * b.sliderRows.at;
    const auto isNear = ((size < near) & (ss < smallestStep * sizeOf(before))) | (size < smallestStep);
    if (areAll(isNear)) {
      b.leftA.at -= along.a / c.horizontal * step;
      b.leftE.at -= along.e / c.vertical * step;
      return true;
    }
    if (!look(b, c)) return false;
    before = step;
  }
  return true;
}

/// One row of derivatives for each kind of reading, what lies along the arc taken off.
struct Rows {
  Eight along[3];  ///< ∂/∂φ, of unit length over all readings of the visit
  Eight reduced[3][columns];
};

template <bool hasSlider>
[[gnu::always_inline]] inline void fill(Rows& rows, const Block& b, const Common& c) {
  constexpr std::size_t kinds = hasSlider ? 3 : 2;
  const Along along = alongArc(b, c);
  const Eight aX = c.horizontal * b.aX.at, eX = c.vertical * b.eX.at, eY = c.vertical * b.eY.at;
  const Eight none{};
  const Eight slider = c.slider * b.sliderRows.at;
  const Eight derivatives[3][columns] = {
      {aX, none, aX * b.cosine.at, none, none - c.horizontal, none, c.horizontal * b.aL.at},
      {eX, eY, eX * b.cosine.at + eY * b.sine.at, none, none, none + c.vertical, c.vertical * b.eL.at},
      {none, none, none, slider, none, none, none}};
  const Eight counts[3] = {b.rows.at, b.rows.at, b.sliderRows.at};
  rows.along[0] = along.a;
  rows.along[1] = along.e;
  rows.along[2] = slider * c.turn;
  Eight square{};
  for (std::size_t k = 0; k < kinds; ++k) square += counts[k] * rows.along[k] * rows.along[k];
  const Eight perLength = 1 / root(square);
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
[[gnu::always_inline]] inline void add(Sums& sums, const Block& b, const Common& c) {
  constexpr std::size_t kinds = hasSlider ? 3 : 2;
  Rows rows;
  fill<hasSlider>(rows, b, c);
  const Eight left[3] = {c.horizontal * b.leftA.at, c.vertical * b.leftE.at, c.slider * b.sliderLeft.at};
  const Eight counts[3] = {b.counts.at, b.counts.at, b.sliderCounts.at};
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
[[gnu::always_inline]] inline void addAll(const std::vector<Block>& blocks, const Common& common,
                                          ArcEquations& equations) {
  Sums sums;
  for (const Block& block : blocks) add<hasSlider>(sums, block, common);
  for (std::size_t i = 0; i < ArcEquations::estimated; ++i) {
    for (std::size_t j = i; j < columns; ++j) {
      equations.normal[i][j] = total(sums.normal[i][j]);
      if (j < ArcEquations::estimated) equations.normal[j][i] = equations.normal[i][j];
    }
    equations.rightSide[i] = total(sums.rightSide[i]);
  }
  equations.chiSquare = total(sums.chiSquare);
}

// The entries.

ALIDADE_WIDE void standInPlane(Block& block, const Common& common) {
  stand(block, common);
}

/// False where the block is to be settled visit by visit: then they stand where they stood.
ALIDADE_WIDE bool settle(Block& block, const Common& common) {
  const Eight cosine = block.cosine.at, sine = block.sine.at;
  const bool isSettled = settleTogether(block, common);
  if (isSettled) return true;
  block.cosine.at = cosine;
  block.sine.at = sine;
  return false;
}

ALIDADE_WIDE void addUp(const std::vector<Block>& blocks, const Common& common, bool hasSlider,
                        ArcEquations& equations) {
  hasSlider ? addAll<true>(blocks, common, equations) : addAll<false>(blocks, common, equations);
}

struct ReliabilityOfEight {
  EightKept redundancy[3], rate[3];
};

ALIDADE_WIDE void rely(const Block& block, const Common& common, const VisitFeet::Cofactor& cofactor,
                       const std::array<double, 4>& asked, ReliabilityOfEight& result) {
  Rows rows;
  fill<true>(rows, block, common);
  for (std::size_t k = 0; k < 3; ++k) {
    Eight redundancy = 1 - rows.along[k] * rows.along[k], rate{};
    for (std::size_t i = 0; i < ArcEquations::estimated; ++i) {
      Eight turned{};
      for (std::size_t j = 0; j < ArcEquations::estimated; ++j) turned += cofactor[i][j] * rows.reduced[k][j];
      redundancy -= rows.reduced[k][i] * turned;
      rate += rows.reduced[k][i] * asked[i];
    }
    result.redundancy[k].at = redundancy;
    result.rate[k].at = rate;
  }
}

VisitReading readingIn(const Block& block, std::size_t i) {
  VisitReading reading;
  reading.tanA = block.tanA.at[i];
  reading.tanE = block.tanE.at[i];
  reading.rows = block.rows.at[i];
  if (block.sliderRows.at[i] != 0) reading.slider = block.slider.at[i];
  return reading;
}

}  // namespace

void VisitFeet::add(const VisitReading& visit) {
  const std::size_t first = m_size++ % eight;
  if (first == 0) m_blocks.emplace_back();
  Block& b = m_blocks.back();
  for (std::size_t i = first; i < eight; ++i) {
    b.tanA.at[i] = visit.tanA;
    b.tanE.at[i] = visit.tanE;
    b.rows.at[i] = visit.rows;
    b.slider.at[i] = visit.slider.value_or(0);
    b.sliderRows.at[i] = visit.slider ? 1 : 0;
  }
  b.counts.at[first] = visit.rows;
  b.sliderCounts.at[first] = b.sliderRows.at[first];
  m_hasSlider = m_hasSlider || visit.slider;
}

VisitReading VisitFeet::reading(std::size_t visit) const {
  return readingIn(m_blocks[visit / eight], visit % eight);
}

/// What the sliders leave where the visits stand.
void VisitFeet::lookAtSliders(Block& block, const ArcUnknowns& unknowns) const {
  for (std::size_t i = 0; i < eight; ++i) {
    if (block.sliderRows.at[i] == 0) continue;
    const double phi = std::atan2(block.sine.at[i], block.cosine.at[i]);
    const double left = block.slider.at[i] - unknowns.sliderZero - m_view.turn * phi;
    block.sliderLeft.at[i] = wrapped(Angle::fromRadians(left)).radians();
  }
}

ArcEquations VisitFeet::settle(const ArcUnknowns& unknowns, From from) {
  const Common common(m_view, unknowns);
  const double zeroMoved = unknowns.sliderZero - m_unknowns.sliderZero;
  for (Block& block : m_blocks) {
    if (from == From::Plane) standInPlane(block, common);
    if (m_hasSlider && from == From::Plane) lookAtSliders(block, unknowns);
    if (m_hasSlider && from == From::Before)
      for (std::size_t i = 0; i < eight; ++i) block.sliderLeft.at[i] -= zeroMoved * block.sliderRows.at[i];
    if (!alidade::settle(block, common)) settleApart(block, unknowns, from);
  }
  m_unknowns = unknowns;
  ArcEquations equations;
  addUp(m_blocks, common, m_hasSlider, equations);
  return equations;
}

void VisitFeet::settleApart(Block& block, const ArcUnknowns& unknowns, From from) const {
  for (std::size_t i = 0; i < eight; ++i) {
    FootPoint foot;
    foot.cosine = block.cosine.at[i];
    foot.sine = block.sine.at[i];
    foot.phi = std::atan2(foot.sine, foot.cosine);
    const VisitReading visit = readingIn(block, i);
    foot =
        from == From::Plane ? footPoint(m_view, unknowns, visit) : footPoint(m_view, unknowns, visit, foot);
    block.cosine.at[i] = foot.cosine;
    block.sine.at[i] = foot.sine;
    block.leftA.at[i] = foot.left.a;
    block.leftE.at[i] = foot.left.e;
    block.sliderLeft.at[i] = foot.sliderLeft;
    block.aX.at[i] = foot.aX;
    block.aL.at[i] = foot.aL;
    block.eX.at[i] = foot.eX;
    block.eY.at[i] = foot.eY;
    block.eL.at[i] = foot.eL;
  }
}

double VisitFeet::arcAngle(std::size_t visit) const {
  const Block& block = m_blocks[visit / eight];
  return std::atan2(block.sine.at[visit % eight], block.cosine.at[visit % eight]);
}

Direction<double> VisitFeet::left(std::size_t visit) const {
  const Block& block = m_blocks[visit / eight];
  return {block.leftA.at[visit % eight], block.leftE.at[visit % eight]};
}

double VisitFeet::sliderLeft(std::size_t visit) const {
  return m_blocks[visit / eight].sliderLeft.at[visit % eight];
}

std::array<VisitReliability, eight> VisitFeet::reliabilityOf(
    std::size_t block, const Cofactor& cofactor,
    const std::array<double, ArcEquations::estimated>& asked) const {
  ReliabilityOfEight together;
  rely(m_blocks[block], Common(m_view, m_unknowns), cofactor, asked, together);
  std::array<VisitReliability, eight> apart;
  for (std::size_t i = 0; i < eight; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      apart[i].redundancy[k] = together.redundancy[k].at[i];
      apart[i].rate[k] = together.rate[k].at[i];
    }
  return apart;
}

}  // namespace alidade

#include "core/adjustment/arc/fast_arc_fit.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <thread>

#include "core/adjustment/arc/fast_arc_kernel.h"
#include "core/base/random_source.h"

namespace alidade {

namespace {

using namespace arc_kernel;

constexpr double unlike = 0.01;  // limit of the relative difference in remainder between the part and all
constexpr int mostSurveys = 2;   // if two do not suffice, the residuals are too large for surveys
constexpr std::size_t pilotPlaces = 16384;

const ArcKernel& kernel() {
#ifdef ALIDADE_HAS_WIDE_KERNEL
  static const ArcKernel& chosen =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? wideKernel : plainKernel;
  return chosen;
#else
  return plainKernel;
#endif
}

Setup inside(const ArcSetup& setup, double tolerance = usualTolerance) {
  return {{setup.sigmaHorizontal * setup.sigmaHorizontal, setup.sigmaVertical * setup.sigmaVertical},
          setup.distance,
          setup.relation == VerticalAngleRelation::Exact,
          tolerance};
}

double lane(double value, std::size_t /*lane*/) {
  return value;
}

double lane(const Lanes& values, std::size_t index) {
  return values[index];
}

/// Absent if the fit is refused.
template <typename T>
std::optional<FastArcFit> fitIn(const Conclusion<T>& c, std::size_t i = 0) {
  if (lane(c.sound, i) == 0) return std::nullopt;
  const auto at = [i](const T& values) { return lane(values, i); };
  return FastArcFit{
      {at(c.x), at(c.y), at(c.radius)},
      {{{at(c.xx), at(c.xy), at(c.xr)}, {at(c.xy), at(c.yy), at(c.yr)}, {at(c.xr), at(c.yr), at(c.rr)}}},
      at(c.chiSquare),
      c.iterations};
}

/// Keeps all places in memory from one iteration to the next.
std::optional<FastArcFit> fitKept(const ArcSetup& setup, const Readings& readings,
                                  const ReadingResiduals& residuals) {
  constexpr std::size_t fewBlocks = 16;
  std::array<PlaceEquation, fewBlocks> few;
  std::vector<PlaceEquation> many;
  PlaceEquation* places = few.data();
  if (readings.blocks() > fewBlocks) {
    many.resize(readings.blocks());
    places = many.data();
  }
  Outcome<double> outcome;
  kernel().solveOne(places, readings, inside(setup), residuals, outcome);
  return fitIn(concluded(outcome, setup.distance));
}

/// Blocks of places, one chosen at random from each of equally long stretches of the readings.
struct Part {
  std::vector<double> a, e, rows;

  explicit Part(const Readings& readings) : a(pilotPlaces), e(pilotPlaces), rows(pilotPlaces, 1) {
    constexpr std::size_t blocks = pilotPlaces / width;
    RandomSource random(1, readings.count);
    const double stretch = static_cast<double>(readings.count - width) / static_cast<double>(blocks);
    for (std::size_t i = 0; i < blocks; ++i) {
      const auto from = static_cast<std::size_t>((static_cast<double>(i) + random.uniform()) * stretch);
      std::copy_n(readings.a + from, width, &a[i * width]);
      std::copy_n(readings.e + from, width, &e[i * width]);
      if (readings.rows) std::copy_n(readings.rows + from, width, &rows[i * width]);
    }
  }

  Readings readings() const { return {a.data(), e.data(), rows.data(), pilotPlaces}; }
};

using Vector = std::array<double, 3>;  // derivatives with respect to x, y and `half`

Vector gradient(const CloseSums<double>& sums) {
  return {sums.xw, sums.yw, sums.w};
}

Vector times(const Normals<double>& n, const Step<double>& q) {
  return {n.xx * q.x + n.xy * q.y + n.x * q.half, n.xy * q.x + n.yy * q.y + n.y * q.half,
          n.x * q.x + n.y * q.y + n.one * q.half};
}

/// Estimates the second derivatives of all places after the step, from the change in the part.
Information<double> atEnd(const Information<double>& all, const Information<double>& before,
                          const Information<double>& after) {
  const double ratio = all.one / before.one;
  const auto moved = [&](double Information<double>::*sum) {
    return all.*sum + ratio * (after.*sum - before.*sum);
  };
  using I = Information<double>;
  return {moved(&I::one), moved(&I::x), moved(&I::y), moved(&I::xx), moved(&I::xy), moved(&I::yy)};
}

/// Corrects the step of `progress`, which was computed from `all`; its error grows with the square of its
/// length. The gradients of the part, `before` and `after` the step, show what the second derivatives omit.
void mend(Progress<double>& progress, const CloseSums<double>& all, const CloseSums<double>& before,
          const CloseSums<double>& after) {
  const Step<double> step = progress.step;
  const Vector whole = gradient(all), wholeChange = times(all, step);
  const Vector first = gradient(before), partChange = times(before, step);
  Vector second = gradient(after);  // gradient with respect to (x, y, half) at the circle after the step
  second[0] += step.x * second[2];
  second[1] += step.y * second[2];
  Vector left;
  for (std::size_t i = 0; i < 3; ++i)
    left[i] = whole[i] - wholeChange[i] + all.one / before.one * (second[i] - first[i] + partChange[i]);
  Step<double> rest = times(progress.inverse, left[0], left[1], left[2]);
  rest.half += step.x * rest.x + step.y * rest.y;  // in the frame of the circle after the step
  const double perSquare = 1 / progress.disc.square;
  progress.disc = moved(progress.disc, rest);
  progress.inverse = invert(atEnd(all, before, after), progress.disc.square);
  progress.remaining = progress.chance + unlike * extent(rest, std::sqrt(perSquare), perSquare);
}

bool isConverged(const Progress<double>& progress) {
  return progress.remaining < usualTolerance;
}

/// Fits a part of the places first, then all places, without storing their equations.
std::optional<FastArcFit> fitStreamed(const ArcSetup& setup, const Readings& readings,
                                      const ReadingResiduals& residuals) {
  const Part part(readings);
  const auto pilot = fitKept(setup, part.readings(), {});
  if (!pilot) return std::nullopt;

  const Setup inner = inside(setup);
  const double l = setup.distance, pilotRadius = pilot->circle.radius / l;
  Outcome<double> outcome;
  Progress<double>& progress = outcome.progress;
  progress.perRootPlaces = 1 / std::sqrt(static_cast<double>(readings.count));
  progress.disc = {pilot->circle.x / l, pilot->circle.y / l, pilotRadius * pilotRadius};
  outcome.iterations = pilot->iterations;
  for (int surveys = 0; surveys < mostSurveys && !isConverged(progress) && progress.chance < usualTolerance;
       ++surveys, ++outcome.iterations) {
    Survey all, before, after;
    kernel().survey(readings, inner, progress.disc, all);
    if (all.largestResidual > largestResidual) return std::nullopt;  // later steps hardly change residuals
    kernel().survey(part.readings(), inner, progress.disc, before);
    progress.anisotropy = anisotropyOf(inner.variances, all.largestReading * all.largestReading);
    advance(progress, all.sums);
    kernel().survey(part.readings(), inner, progress.disc, after);
    mend(progress, all.sums, before.sums, after.sums);
    outcome.largestReading = all.largestReading;
    outcome.largestResidual = all.largestResidual;
  }
  for (Sweep sweep; !isConverged(progress) && outcome.iterations < mostIterations; ++outcome.iterations) {
    kernel().sweep(readings, inner, progress.disc, {}, sweep);
    const double residual = scatter(sweep.sums, 1 / progress.disc.square);
    progress.lag = 0.5 * residual * residual * residual;  // distance of linearisation points after two steps
    advance(progress, sweep.sums);
  }
  const auto fit = fitIn(concluded(outcome, l));
  Sweep last;
  if (fit && !residuals.horizontal.empty()) kernel().sweep(readings, inner, progress.disc, residuals, last);
  return fit;
}

}  // namespace

std::optional<FastArcFit> fitArcFast(const ArcSetup& setup, std::span<const double> a,
                                     std::span<const double> e, std::span<const double> rows,
                                     const ReadingResiduals& residuals) {
  assert(a.size() == e.size() && (rows.empty() || rows.size() == a.size()));
  assert(residuals.horizontal.size() == residuals.vertical.size());
  if (a.size() < 3) return std::nullopt;
  const Readings readings{a.data(), e.data(), rows.empty() ? nullptr : rows.data(), a.size()};
  return a.size() > 2 * pilotPlaces ? fitStreamed(setup, readings, residuals)
                                    : fitKept(setup, readings, residuals);
}

void fitArcsFast(const ArcSetup& setup, std::span<const double> a, std::span<const double> e,
                 std::span<std::optional<FastArcFit>> fits, int threads, double tolerance) {
  assert(a.size() == e.size() && (fits.empty() || a.size() % fits.size() == 0));
  if (a.size() < 3 * fits.size()) std::ranges::fill(fits, std::nullopt);
  if (fits.empty() || a.size() < 3 * fits.size()) return;
  constexpr std::size_t batch = width * sideBySide;
  constexpr std::size_t turn = 64;  // batches that a thread takes at a time: some 70 µs
  const std::size_t count = a.size() / fits.size(), batches = (fits.size() + batch - 1) / batch;
  const Setup inner = inside(setup, tolerance);
  std::atomic<std::size_t> next = 0;  // next batch that no thread has taken
  const auto work = [&] {
    std::vector<PlaceEquation> places(count * sideBySide);
    std::array<Conclusion<Lanes>, sideBySide> conclusions;
    for (std::size_t begin = next.fetch_add(turn); begin < batches; begin = next.fetch_add(turn))
      for (std::size_t first = begin * batch; first < std::min((begin + turn) * batch, fits.size());
           first += batch) {
        const std::size_t held = std::min(batch, fits.size() - first);
        kernel().solveMany(places.data(), a.data() + first * count, e.data() + first * count, count, held,
                           inner, conclusions.data());
        for (std::size_t i = 0; i < held; ++i) fits[first + i] = fitIn(conclusions[i / width], i % width);
      }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
}

}  // namespace alidade

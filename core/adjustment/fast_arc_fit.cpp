#include "core/adjustment/fast_arc_fit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <thread>
#include <type_traits>

namespace alidade {

namespace {

constexpr std::size_t width = 4;
using Lanes = double __attribute__((vector_size(width * sizeof(double))));

constexpr double largestAngle = std::numbers::pi / 4;
constexpr double largestResidual = 0.002;  // rad; the series below are exact to rounding up to there
constexpr double tolerance = 1.5e-12;      // of R: what may be left of the way to the minimum
constexpr double untold = 0.1;             // of what a step leaves, beside the turn of the normals
constexpr double straight = 1e-10;         // variance across times along the chord, of R⁴; some 6° of arc
constexpr int mostIterations = 12;
constexpr std::size_t pilotPlaces = 32768;

/// A pair of readings, and what the last iteration found for it.
struct alignas(sizeof(Lanes)) PlaceEquation {
  Lanes tanA, tanE, secA;  ///< secA: 1 for the planar relation
  Lanes weight;            ///< rows of the visit, 0 for lanes that hold none
  Lanes w, perA, perE;     ///< misclosure, and the residuals of a and e per unit of it
  Lanes cosPhi, sinPhi;
};

template <typename T>
struct Disc {
  T x, y, radius;  // in units of L
};

template <typename T>
struct Step {
  T x, y, rho;
};

/// Σ weight · (products), weight 1/(f_a² σ_h² + f_e² σ_v²).
template <typename T>
struct Sums {
  T one{}, c{}, s{}, cc{}, cs{}, ss{}, w{}, cw{}, sw{}, ww{}, ccw{}, csw{};
};

struct Variances {
  double horizontal, vertical;  // rad²
  double exact;                 // 1 or 0
};

/// Inverse of the normal equations over (x, y, R), and whether they can be told from singular ones.
template <typename T>
struct Inverse {
  T xx, xy, yy, xr, yr, rr;
  T determinacy;
};

/// How far the iteration has come; `remaining` bounds the rest of the way, in units of R.
template <typename T>
struct Progress {
  Disc<T> disc;
  Step<T> step{};
  T places{}, lag{}, remaining{}, chiSquare{};
  Inverse<T> inverse;
};

/// Kåsa's circle through the places (see algebraic_circle.h).
template <typename T>
struct Moments {
  T n{}, x{}, y{}, xx{}, xy{}, yy{}, xz{}, yz{};
};

/// Readings of one arc, four places side by side.
struct Readings {
  const double *a, *e, *rows;  ///< rows: null where all visits have one
  std::size_t count;

  std::size_t blocks() const { return (count + width - 1) / width; }
};

/// What a sweep over places found.
struct Sweep {
  Sums<double> sums;
  double largestReading = 0, largestResidual = 0;
};

template <typename T>
struct alignas(sizeof(Lanes)) Outcome {
  Progress<T> progress;
  T largestReading, largestResidual;
  int iterations = 0;
};

// The same kernel for every processor, and for those with vector units of four doubles.
namespace plain {
#include "core/adjustment/fast_arc_kernel.inc"
}
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define ALIDADE_HAS_WIDE_KERNEL
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace wide {
#include "core/adjustment/fast_arc_kernel.inc"
}
#pragma GCC pop_options
#endif

struct Kernel {
  decltype(&plain::solveOne) solveOne = plain::solveOne;
  decltype(&plain::solveFour) solveFour = plain::solveFour;
  decltype(&plain::sweep) sweep = plain::sweep;
};

const Kernel& kernel() {
#ifdef ALIDADE_HAS_WIDE_KERNEL
  static const Kernel chosen = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
                                   ? Kernel{wide::solveOne, wide::solveFour, wide::sweep}
                                   : Kernel{};
#else
  static const Kernel chosen;
#endif
  return chosen;
}

Variances variancesOf(const ArcSetup& setup) {
  return {setup.sigmaHorizontal * setup.sigmaHorizontal, setup.sigmaVertical * setup.sigmaVertical,
          setup.relation == VerticalAngleRelation::Exact ? 1.0 : 0.0};
}

/// One fit as a plain value.
struct Candidate {
  double largestReading, largestResidual;
  Progress<double> progress;
};

Candidate candidate(const Outcome<Lanes>& outcome, std::size_t lane) {
  const Progress<Lanes>& p = outcome.progress;
  const auto at = [lane](const Lanes& lanes) { return lanes[lane]; };
  Candidate result{at(outcome.largestReading), at(outcome.largestResidual), {}};
  result.progress.disc = {at(p.disc.x), at(p.disc.y), at(p.disc.radius)};
  result.progress.remaining = at(p.remaining);
  result.progress.chiSquare = at(p.chiSquare);
  const Inverse<Lanes>& q = p.inverse;
  result.progress.inverse = {at(q.xx), at(q.xy), at(q.yy), at(q.xr), at(q.yr), at(q.rr), at(q.determinacy)};
  return result;
}

/// Absent where the fit is refused.
std::optional<FastArcFit> judged(const Candidate& fit, int iterations, double distance) {
  const auto& [disc, step, places, lag, remaining, chiSquare, q] = fit.progress;
  const bool isSound = fit.largestReading <= largestAngle && fit.largestResidual <= largestResidual &&
                       remaining < tolerance && q.determinacy > straight && disc.radius > 0;
  if (!isSound) return std::nullopt;
  const double unit = distance * distance;
  return FastArcFit{{disc.x * distance, disc.y * distance, disc.radius * distance},
                    {{{q.xx * unit, q.xy * unit, q.xr * unit},
                      {q.xy * unit, q.yy * unit, q.yr * unit},
                      {q.xr * unit, q.yr * unit, q.rr * unit}}},
                    chiSquare,
                    iterations};
}

/// All places at once, each kept from one iteration to the next.
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
  kernel().solveOne(places, readings, variancesOf(setup), residuals, outcome);
  return judged({outcome.largestReading, outcome.largestResidual, outcome.progress}, outcome.iterations,
                setup.distance);
}

/// An evenly taken part of the places first, then all of them, kept nowhere.
std::optional<FastArcFit> fitStreamed(const ArcSetup& setup, const Readings& readings,
                                      const ReadingResiduals& residuals) {
  std::vector<double> a(pilotPlaces), e(pilotPlaces), rows(pilotPlaces, 1);
  for (std::size_t i = 0; i < pilotPlaces; ++i) {
    const std::size_t from = i * readings.count / pilotPlaces;
    a[i] = readings.a[from];
    e[i] = readings.e[from];
    if (readings.rows) rows[i] = readings.rows[from];
  }
  const Readings part{a.data(), e.data(), rows.data(), pilotPlaces};
  const auto pilot = fitKept(setup, part, {});
  if (!pilot) return std::nullopt;

  const Variances variances = variancesOf(setup);
  const double l = setup.distance;
  Progress<double> progress;
  progress.places = static_cast<double>(readings.count);
  progress.disc = {pilot->circle.x / l, pilot->circle.y / l, pilot->circle.radius / l};
  Sweep whole;
  int sweeps = 0;
  do {
    kernel().sweep(readings, variances, progress.disc, {}, whole);
    progress.lag = whole.sums.ww / whole.sums.one / (2 * progress.disc.radius);
    plain::advance(progress, whole.sums);
  } while (!plain::settled(progress) && ++sweeps < mostIterations);
  const auto fit =
      judged({whole.largestReading, whole.largestResidual, progress}, pilot->iterations + sweeps + 1, l);
  if (fit && !residuals.horizontal.empty())
    kernel().sweep(readings, variances, progress.disc, residuals, whole);
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

std::vector<std::optional<FastArcFit>> fitArcsFast(const ArcSetup& setup, std::size_t fits,
                                                   std::span<const double> a, std::span<const double> e,
                                                   int threads) {
  std::vector<std::optional<FastArcFit>> result(fits);
  if (fits == 0 || a.size() < 3 * fits) return result;
  assert(a.size() == e.size() && a.size() % fits == 0);
  const std::size_t count = a.size() / fits, groups = (fits + width - 1) / width;
  const Variances variances = variancesOf(setup);
  const auto work = [&](std::size_t begin, std::size_t end) {
    std::vector<PlaceEquation> places(count);
    for (std::size_t group = begin; group < end; ++group) {
      Outcome<Lanes> outcome;
      const std::size_t first = group * width, held = std::min(width, fits - first);
      kernel().solveFour(places.data(), a.data() + first * count, e.data() + first * count, count, held,
                         variances, outcome);
      for (std::size_t lane = 0; lane < held; ++lane)
        result[first + lane] = judged(candidate(outcome, lane), outcome.iterations, setup.distance);
    }
  };
  const auto shares = static_cast<std::size_t>(std::max(threads, 1));
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < shares; ++i)
    others.emplace_back(work, groups * i / shares, groups * (i + 1) / shares);
  work(0, groups / shares);
  return result;
}

}  // namespace alidade

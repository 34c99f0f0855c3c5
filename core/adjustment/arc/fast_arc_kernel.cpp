#include "core/adjustment/arc/fast_arc_kernel.h"

#include <type_traits>

namespace alidade::arc_kernel {

namespace {

constexpr std::size_t share = 16;  // blocks of a sweep that are processed together

/// tan x = x + x·z·P/Q, z = x², |x| ≤ π/4, to a relative error of 2e-16. From S. Moshier's Cephes library.
[[gnu::always_inline]] inline Lanes tangentP(const Lanes& z) {
  return (-1.30936939181383777646E4 * z + 1.15351664838587416140E6) * z - 1.79565251976484875988E7;
}

[[gnu::always_inline]] inline Lanes tangentQ(const Lanes& z) {
  return (((z + 1.36812963470692954678E4) * z - 1.32089234440210967447E6) * z + 2.50083801823357915839E7) *
             z -
         5.38695755929454629881E7;
}

/// Computes tan a and tan e of the place, and includes a² and e² in `largest`.
[[gnu::always_inline]] inline void sight(PlaceEquation& place, const Lanes& a, const Lanes& e,
                                         Lanes& largest) {
  const Lanes aa = a * a, ee = e * e;
  largest = larger(largest, larger(aa, ee));
  const Lanes qa = tangentQ(aa), qe = tangentQ(ee);
  const Lanes inverse = 1 / (qa * qe);
  place.tanA = a + a * aa * (tangentP(aa) * (qe * inverse));
  place.tanE = e + e * ee * (tangentP(ee) * (qa * inverse));
}

/// Computes the height of the point, and its derivative with respect to e.
template <bool exact>
[[gnu::always_inline]] inline void raise(PlaceEquation& place) {
  if constexpr (exact) {
    place.secA = root(1 + place.tanA * place.tanA);
    place.y = place.tanE * place.secA;
    place.perRise = place.secA + place.y * place.tanE;
  } else {
    place.y = place.tanE;
    place.perRise = 1 + place.tanE * place.tanE;
  }
}

/// Derivatives of the misclosure with respect to a and e, at a point with distance (ux, uy) from the centre.
struct Slope {
  Lanes a, e;
};

template <bool exact>
[[gnu::always_inline]] inline Slope slope(const Lanes& x, const Lanes& y, const Lanes& perRise,
                                          const Lanes& ux, const Lanes& uy) {
  const Lanes perTurn = 1 + x * x;
  if constexpr (exact) return {ux * perTurn + uy * (x * y), uy * perRise};
  return {ux * perTurn, uy * perRise};
}

/// Adds the weight of a place and its first and second moments.
[[gnu::always_inline]] inline void addMoments(Information<Lanes>& sums, const Lanes& weight, const Lanes& x,
                                              const Lanes& y) {
  const Lanes weightedX = weight * x, weightedY = weight * y;
  sums.one += weight;
  sums.x += weightedX;
  sums.y += weightedY;
  sums.xx += weightedX * x;
  sums.xy += weightedX * y;
  sums.yy += weightedY * y;
}

/// Derivatives of half the sum of squares at a circle, from a series about the readings. With the gradient G
/// of the misclosure f with respect to the readings in units of σ, p = 1/|G|², m = p f, and k, p times the
/// second derivative of f along G:
///
///   first − Σ λ (x*, y*, 1), λ = m (1 + 3/2 m k + 5/2 (m k)²),
///   second Σ p (1 + 3 m k) b bᵀ, b = (x, y, 1),
///
/// where (x*, y*) leads from the centre to the foot, and (x, y) of b to the mirror image of the sighted point
/// at the foot. Exact to second order; the third order holds for errors that are equal in all directions.
template <bool exact, bool weighted>
[[gnu::always_inline]] inline void add(CloseSums<Lanes>& sums, Information<Lanes>& information,
                                       const PlaceEquation& place, const Disc<Lanes>& disc,
                                       const Variances& variances, Lanes& largest) {
  const Lanes x = place.tanA, y = place.y, ux = x - disc.x, uy = y - disc.y;
  const Lanes f = 0.5 * (ux * ux + uy * uy) - 0.5 * disc.square;
  const Slope slopes = slope<exact>(x, y, place.perRise, ux, uy);
  const Lanes va = variances.horizontal * slopes.a, ve = variances.vertical * slopes.e;
  const Lanes turned = va * slopes.a, p = 1 / (turned + ve * slopes.e);
  // Seen from the point, the foot is at −m (dx, dy), plus the change of dx and dy along the way.
  const Lanes dx = va + x * (x * va), rise = place.perRise * ve, tip = 2 * (place.tanE * ve) * rise;
  Lanes dy = rise, k;
  if constexpr (exact) {
    dy += (x * y) * va;
    k = p * (dx * dx + dy * dy + uy * (y * (va * va) + tip)) + 2 * (x * va);
  } else {
    k = p * (dx * dx + dy * dy + uy * tip + 2 * (x * va) * turned);
  }
  const Lanes m = f * p, mk = m * k, squares = m * f;
  largest = larger(largest, squares);
  const Lanes weight = weighted ? place.weight : broadcast(1);
  const Lanes force = weight * (m + m * (mk * (1.5 + 2.5 * mk)));
  const Lanes inwards = m + 0.5 * (m * mk);
  const Lanes footX = ux - inwards * dx, footY = uy - inwards * dy;
  const Lanes beyondX = footX - inwards * dx, beyondY = footY - inwards * dy;
  const Lanes pmk = p * mk, stiffness = weight * (p + 3 * pmk), precision = weight * (p + 2 * pmk);
  const Lanes weightedSquares = weight * squares;
  addMoments(sums, stiffness, beyondX, beyondY);
  sums.w += force;
  sums.xw += force * footX;
  sums.yw += force * footY;
  sums.ww += weightedSquares + weightedSquares * (mk * (1 + 1.25 * mk));
  addMoments(information, precision, footX, footY);
  const Lanes mkmk = mk * mk;
  sums.third += (weightedSquares * mkmk) * mkmk;
}

/// Weights the condition stored in `place` and adds it to the sums. A pass of its own after the
/// linearisation, so that the divisions of one place do not delay other places.
template <bool weighted>
[[gnu::always_inline]] inline void weigh(PlaceEquation& place, const Variances& variances,
                                         Sums<Lanes>& sums) {
  const Lanes fa = place.perA, fe = place.perE;
  const Lanes varianceA = variances.horizontal * fa, varianceE = variances.vertical * fe;
  const Lanes inverse = 1 / (varianceA * fa + varianceE * fe);
  place.perA = varianceA * inverse;
  place.perE = varianceE * inverse;
  const Lanes p = weighted ? place.weight * inverse : inverse;
  const Lanes x = place.ux, y = place.uy, w = place.w;
  const Lanes pw = p * w, pwx = pw * x;
  addMoments(sums, p, x, y);
  sums.w += pw;
  sums.xw += pwx;
  sums.yw += pw * y;
  sums.ww += pw * w;
  sums.xxw += pwx * x;
  sums.xyw += pwx * y;
}

/// Linearises the condition at the readings themselves. The misclosure is R times the distance from the
/// circle, exact to second order.
template <bool exact>
[[gnu::always_inline]] inline void approach(PlaceEquation& place, const Disc<Lanes>& disc,
                                            const Lanes& perSquare) {
  const Lanes x = place.tanA, y = place.y;
  const Lanes ux = x - disc.x, uy = y - disc.y;
  const Lanes w = 0.5 * (ux * ux + uy * uy) - 0.5 * disc.square;
  const Lanes off = w * perSquare, inwards = 1 - off;
  place.w = w - 0.5 * off * w;
  place.ux = ux * inwards;
  place.uy = uy * inwards;
  const Slope f = slope<exact>(x, y, place.perRise, place.ux, place.uy);
  place.perA = f.a;
  place.perE = f.e;
}

/// The misclosure that remains after the step: multiplied by perA, perE it corrects the readings.
[[gnu::always_inline]] inline Lanes misclosure(const PlaceEquation& place, const Step<Lanes>& step) {
  return (place.w - step.half) - (place.ux * step.x + place.uy * step.y);
}

/// tan u/(1 + t tan u) for a small u: the decrease of tan x = t, per 1 + t², when x becomes x − u.
[[gnu::always_inline]] inline Lanes shortened(const Lanes& t, const Lanes& u) {
  const Lanes tt = t * t;
  return u * (1 + u * (u * ((tt + 1.0 / 3) - u * (t * (tt + 2.0 / 3))) - t));
}

/// Linearises the condition at the readings minus the residuals after `step`, for the circle after the step.
template <bool exact>
[[gnu::always_inline]] inline void linearise(PlaceEquation& place, const Step<Lanes>& step,
                                             const Disc<Lanes>& disc, Lanes& largest) {
  const Lanes left = misclosure(place, step);
  const Lanes u = left * place.perA, v = left * place.perE, uu = u * u;
  largest = larger(largest, uu + v * v);
  const Lanes overU = shortened(place.tanA, u);
  const Lanes x = place.tanA - (1 + place.tanA * place.tanA) * overU;
  const Lanes tanE = place.tanE - (1 + place.tanE * place.tanE) * shortened(place.tanE, v);
  Lanes secA = broadcast(1), y = tanE;
  if constexpr (exact) {
    secA = place.secA * (1 + uu * (0.5 + uu * (5.0 / 24))) * (1 - place.tanA * overU);
    y = tanE * secA;
  }
  place.ux = x - disc.x;
  place.uy = y - disc.y;
  const Slope f = slope<exact>(x, y, secA * (1 + tanE * tanE), place.ux, place.uy);
  place.w = 0.5 * (place.ux * place.ux + place.uy * place.uy) - 0.5 * disc.square + f.a * u + f.e * v;
  place.perA = f.a;
  place.perE = f.e;
}

[[gnu::always_inline]] inline double total(const Lanes& lanes) {
  double sum = 0;
  for (std::size_t i = 0; i < width; ++i) sum += lanes[i];
  return sum;
}

// Combine the lanes if all hold one arc (T: double); keep them apart if each holds another arc (T: Lanes).

template <typename T>
[[gnu::always_inline]] inline T gathered(const Lanes& sum) {
  if constexpr (std::is_same_v<T, double>)
    return total(sum);
  else
    return sum;
}

template <typename T>
[[gnu::always_inline]] inline Information<T> gathered(const Information<Lanes>& s) {
  return {gathered<T>(s.one), gathered<T>(s.x),  gathered<T>(s.y),
          gathered<T>(s.xx),  gathered<T>(s.xy), gathered<T>(s.yy)};
}

template <typename T>
[[gnu::always_inline]] inline Normals<T> gathered(const Normals<Lanes>& s) {
  return {gathered<T>(static_cast<const Information<Lanes>&>(s)), gathered<T>(s.w), gathered<T>(s.xw),
          gathered<T>(s.yw), gathered<T>(s.ww)};
}

template <typename T>
[[gnu::always_inline]] inline Sums<T> gathered(const Sums<Lanes>& s) {
  return {gathered<T>(static_cast<const Normals<Lanes>&>(s)), gathered<T>(s.xxw), gathered<T>(s.xyw)};
}

template <typename T>
[[gnu::always_inline]] inline CloseSums<T> gathered(const CloseSums<Lanes>& s) {
  return {gathered<T>(static_cast<const Normals<Lanes>&>(s)), gathered<T>(s.third)};
}

template <typename T>
[[gnu::always_inline]] inline T greatest(const Lanes& lanes) {
  if constexpr (std::is_same_v<T, double>) {
    double result = lanes[0];
    for (std::size_t i = 1; i < width; ++i) result = larger(result, lanes[i]);
    return result;
  } else {
    return lanes;
  }
}

/// Adds the moments of a place about the optical axis. The digits lost by this origin are not needed.
template <bool weighted>
[[gnu::always_inline]] inline void add(Moments<Lanes>& sums, const PlaceEquation& place) {
  const Lanes x = place.tanA, y = place.y, z = x * x + y * y;
  const Lanes weightX = weighted ? place.weight * x : x, weightY = weighted ? place.weight * y : y;
  if constexpr (weighted) sums.n += place.weight;
  sums.x += weightX;
  sums.y += weightY;
  sums.xx += weightX * x;
  sums.xy += weightX * y;
  sums.yy += weightY * y;
  sums.xz += weightX * z;
  sums.yz += weightY * z;
}

template <typename T>
[[gnu::always_inline]] inline Disc<T> algebraicDisc(const Moments<Lanes>& sums, const T& inverse) {
  const T sumX = gathered<T>(sums.x), sumY = gathered<T>(sums.y), sumXX = gathered<T>(sums.xx),
          sumYY = gathered<T>(sums.yy);
  const T meanX = sumX * inverse, meanY = sumY * inverse, spread = sumXX + sumYY;
  const T xx = sumXX - sumX * meanX, xy = gathered<T>(sums.xy) - sumX * meanY, yy = sumYY - sumY * meanY;
  const T xz = gathered<T>(sums.xz) - spread * meanX, yz = gathered<T>(sums.yz) - spread * meanY;
  const T half = 0.5 / (xx * yy - xy * xy);
  const T x = (yy * xz - xy * yz) * half, y = (xx * yz - xy * xz) * half;
  const T fromX = x - meanX, fromY = y - meanY;
  return {x, y, fromX * fromX + fromY * fromY + (xx + yy) * inverse};
}

/// Loads a block of readings; lanes past the end hold reading 0 with weight 0.
[[gnu::always_inline]] inline void load(const Readings& readings, std::size_t block, Lanes& a, Lanes& e,
                                        Lanes& weight) {
  const std::size_t first = block * width;
  if (first + width <= readings.count) {
    __builtin_memcpy(&a, readings.a + first, sizeof a);
    __builtin_memcpy(&e, readings.e + first, sizeof e);
    weight = broadcast(1);
    if (readings.rows) __builtin_memcpy(&weight, readings.rows + first, sizeof weight);
    return;
  }
  for (std::size_t lane = 0; lane < width; ++lane) {
    const bool holds = first + lane < readings.count;
    const std::size_t i = holds ? first + lane : 0;
    a[lane] = readings.a[i];
    e[lane] = readings.e[i];
    weight[lane] = !holds ? 0 : readings.rows ? readings.rows[i] : 1;
  }
}

[[gnu::always_inline]] inline bool isConverged(const Outcome<double>& outcome) {
  return outcome.progress.remaining < outcome.tolerance;
}

[[gnu::always_inline]] inline bool isConverged(const Outcome<Lanes>& outcome) {
  for (std::size_t lane = 0; lane < width; ++lane)
    if (!(outcome.progress.remaining[lane] < outcome.tolerance)) return false;
  return true;
}

template <bool exact, typename T>
[[gnu::always_inline]] inline CloseSums<T> closed(const PlaceEquation* places, std::size_t blocks,
                                                  const Variances& variances, Outcome<T>& outcome,
                                                  Information<T>& information) {
  const Disc<Lanes> disc = broadcast(outcome.progress.disc);
  Lanes largest{};
  CloseSums<Lanes> sums;
  Information<Lanes> inLanes;
  for (std::size_t i = 0; i < blocks; ++i)
    add<exact, std::is_same_v<T, double>>(sums, inLanes, places[i], disc, variances, largest);
  information = gathered<T>(inLanes);
  outcome.largestResidual = root(greatest<T>(largest) * larger(variances.horizontal, variances.vertical));
  return gathered<T>(sums);
}

/// Restarts the linearisation at the readings themselves.
template <bool exact, typename T>
[[gnu::always_inline]] inline void approached(PlaceEquation* places, std::size_t blocks,
                                              const Variances& variances, Progress<T>& progress) {
  const Disc<Lanes> disc = broadcast(progress.disc);
  const Lanes perSquare = 1 / disc.square;
  Sums<Lanes> sums;
  for (std::size_t i = 0; i < blocks; ++i) approach<exact>(places[i], disc, perSquare);
  for (std::size_t i = 0; i < blocks; ++i) weigh<std::is_same_v<T, double>>(places[i], variances, sums);
  const T off = scatter<T>(gathered<T>(sums), 1 / progress.disc.square);
  progress.lag = 8 * off * off;
  progress.step = Step<T>{};
}

template <bool exact, typename T>
[[gnu::always_inline]] inline Sums<T> linearised(PlaceEquation* places, std::size_t blocks,
                                                 const Variances& variances, Outcome<T>& outcome) {
  const Disc<Lanes> disc = broadcast(outcome.progress.disc);
  const Step<Lanes> step = broadcast(outcome.progress.step);
  Lanes largest{};
  Sums<Lanes> sums;
  for (std::size_t i = 0; i < blocks; ++i) linearise<exact>(places[i], step, disc, largest);
  for (std::size_t i = 0; i < blocks; ++i) weigh<std::is_same_v<T, double>>(places[i], variances, sums);
  outcome.largestResidual = root(greatest<T>(largest));
  return gathered<T>(sums);
}

/// Iterates the fits of `sets` sets of `blocks` blocks, each fit from the circle in its outcome. A set holds
/// the places of one arc (T double) or of four arcs (T Lanes). The equations of all sets are solved
/// alternately, so that their latencies overlap.
template <bool exact, std::size_t sets, typename T>
[[gnu::always_inline]] inline void iterate(PlaceEquation* places, std::size_t blocks,
                                           const Variances& variances, Outcome<T>* outcomes) {
  CloseSums<T> sums[sets];
  Information<T> information[sets];
  for (std::size_t k = 0; k < sets; ++k)
    sums[k] = closed<exact>(places + k * blocks, blocks, variances, outcomes[k], information[k]);
  for (std::size_t k = 0; k < sets; ++k) {
    advance(outcomes[k].progress, sums[k]);
    outcomes[k].progress.inverse = invert(information[k], outcomes[k].progress.disc.square);
  }
  for (std::size_t k = 0; k < sets; ++k) {
    Outcome<T>& outcome = outcomes[k];
    outcome.iterations = 1;
    if (isConverged(outcome)) continue;
    approached<exact>(places + k * blocks, blocks, variances, outcome.progress);
    do advance(outcome.progress, linearised<exact>(places + k * blocks, blocks, variances, outcome));
    while (++outcome.iterations < mostIterations && !isConverged(outcome));
  }
}

[[gnu::always_inline]] inline void writeResiduals(const PlaceEquation& place, const Step<Lanes>& step,
                                                  std::size_t first, const ReadingResiduals& residuals) {
  const Lanes left = misclosure(place, step);
  const Lanes u = left * place.perA, v = left * place.perE;
  for (std::size_t lane = 0; lane < width && first + lane < residuals.horizontal.size(); ++lane) {
    residuals.horizontal[first + lane] = u[lane];
    residuals.vertical[first + lane] = v[lane];
  }
}

template <bool exact>
[[gnu::always_inline]] inline void solveOneWith(PlaceEquation* places, const Readings& readings,
                                                const Variances& variances, const ReadingResiduals& residuals,
                                                Outcome<double>& outcome) {
  Lanes largest{};
  Moments<Lanes> moments;
  for (std::size_t i = 0; i < readings.blocks(); ++i) {
    Lanes a, e;
    load(readings, i, a, e, places[i].weight);
    sight(places[i], a, e, largest);
  }
  for (std::size_t i = 0; i < readings.blocks(); ++i) {
    raise<exact>(places[i]);
    add<true>(moments, places[i]);
  }
  outcome.largestReading = root(greatest<double>(largest));
  const double perPlaces = 1 / total(moments.n);
  outcome.progress.perRootPlaces = root(perPlaces);
  outcome.progress.anisotropy = anisotropyOf(variances, greatest<double>(largest));
  outcome.progress.disc = algebraicDisc(moments, perPlaces);
  iterate<exact, 1>(places, readings.blocks(), variances, &outcome);
  if (residuals.horizontal.empty()) return;
  if (outcome.iterations == 1) {
    approached<exact>(places, readings.blocks(), variances, outcome.progress);
    linearised<exact>(places, readings.blocks(), variances, outcome);
  }
  const Step<Lanes> step = broadcast(outcome.progress.step);
  for (std::size_t i = 0; i < readings.blocks(); ++i) writeResiduals(places[i], step, i * width, residuals);
}

/// Loads the `count` readings of `width` fits, one fit after the other. If there are fewer fits, the first
/// fit fills the other lanes.
[[gnu::always_inline]] inline void sightFits(PlaceEquation* places, const double* a, const double* e,
                                             std::size_t count, std::size_t fits, Outcome<Lanes>& outcome) {
  std::size_t from[width];
  for (std::size_t lane = 0; lane < width; ++lane) from[lane] = lane < fits ? lane * count : 0;
  Lanes largest{};
  for (std::size_t i = 0; i < count; ++i) {
    Lanes laneA, laneE;
    for (std::size_t lane = 0; lane < width; ++lane) {
      laneA[lane] = a[from[lane] + i];
      laneE[lane] = e[from[lane] + i];
    }
    sight(places[i], laneA, laneE, largest);
  }
  outcome.largestReading = root(largest);
}

template <bool exact>
[[gnu::always_inline]] inline void solveManyWith(PlaceEquation* places, const double* a, const double* e,
                                                 std::size_t count, std::size_t fits, const Setup& setup,
                                                 Conclusion<Lanes>* conclusions) {
  Outcome<Lanes> outcomes[sideBySide];
  Moments<Lanes> moments[sideBySide];
  const Lanes perPlaces = broadcast(1 / static_cast<double>(count));
  for (std::size_t k = 0; k < sideBySide; ++k) {
    const std::size_t first = k * width < fits ? k * width : 0;
    sightFits(places + k * count, a + first * count, e + first * count, count, fits - first, outcomes[k]);
    for (std::size_t i = k * count; i < (k + 1) * count; ++i) {
      raise<exact>(places[i]);
      add<false>(moments[k], places[i]);
    }
  }
  for (std::size_t k = 0; k < sideBySide; ++k) {
    outcomes[k].tolerance = setup.tolerance;
    outcomes[k].progress.perRootPlaces = root(perPlaces);
    outcomes[k].progress.anisotropy =
        anisotropyOf(setup.variances, outcomes[k].largestReading * outcomes[k].largestReading);
    outcomes[k].progress.disc = algebraicDisc(moments[k], perPlaces);
  }
  iterate<exact, sideBySide>(places, count, setup.variances, outcomes);
  for (std::size_t k = 0; k < sideBySide; ++k) conclusions[k] = concluded(outcomes[k], setup.distance);
}

/// Computes the sighted points of `blocks` blocks of readings from `first` on.
template <bool exact>
[[gnu::always_inline]] inline void sightShare(const Readings& readings, std::size_t first, std::size_t blocks,
                                              PlaceEquation* places, Lanes& largest) {
  for (std::size_t i = 0; i < blocks; ++i) {
    Lanes a, e;
    load(readings, first + i, a, e, places[i].weight);
    sight(places[i], a, e, largest);
  }
  for (std::size_t i = 0; i < blocks; ++i) raise<exact>(places[i]);
}

/// One sweep over readings without storing their equations. Writes the residuals if requested.
template <bool exact>
[[gnu::always_inline]] inline void sweepWith(const Readings& readings, const Variances& variances,
                                             const Disc<double>& at, const ReadingResiduals& residuals,
                                             Sweep& result) {
  PlaceEquation places[share];
  const Disc<Lanes> disc = broadcast(at);
  const Lanes perSquare = 1 / disc.square;
  Sums<Lanes> sums, ignored;
  Lanes largest{}, largestAngles{};
  for (std::size_t first = 0; first < readings.blocks(); first += share) {
    const std::size_t blocks = first + share < readings.blocks() ? share : readings.blocks() - first;
    sightShare<exact>(readings, first, blocks, places, largestAngles);
    for (std::size_t i = 0; i < blocks; ++i) approach<exact>(places[i], disc, perSquare);
    for (std::size_t i = 0; i < blocks; ++i) weigh<true>(places[i], variances, ignored);
    for (std::size_t i = 0; i < blocks; ++i) linearise<exact>(places[i], Step<Lanes>{}, disc, largest);
    for (std::size_t i = 0; i < blocks; ++i) weigh<true>(places[i], variances, ignored);
    for (std::size_t i = 0; i < blocks; ++i) linearise<exact>(places[i], Step<Lanes>{}, disc, largest);
    for (std::size_t i = 0; i < blocks; ++i) weigh<true>(places[i], variances, sums);
    if (residuals.horizontal.empty()) continue;
    for (std::size_t i = 0; i < blocks; ++i)
      writeResiduals(places[i], Step<Lanes>{}, (first + i) * width, residuals);
  }
  result.sums = gathered<double>(sums);
  result.largestReading = root(greatest<double>(largestAngles));
  result.largestResidual = root(greatest<double>(largest));
}

/// One pass over readings that computes the `CloseSums`, without storing their equations.
template <bool exact>
[[gnu::always_inline]] inline void surveyWith(const Readings& readings, const Variances& variances,
                                              const Disc<double>& at, Survey& result) {
  PlaceEquation places[share];
  const Disc<Lanes> disc = broadcast(at);
  CloseSums<Lanes> sums;
  Information<Lanes> ignored;
  Lanes largest{}, largestAngles{};
  for (std::size_t first = 0; first < readings.blocks(); first += share) {
    const std::size_t blocks = first + share < readings.blocks() ? share : readings.blocks() - first;
    sightShare<exact>(readings, first, blocks, places, largestAngles);
    if (readings.rows || (first + blocks) * width > readings.count)
      for (std::size_t i = 0; i < blocks; ++i)
        add<exact, true>(sums, ignored, places[i], disc, variances, largest);
    else
      for (std::size_t i = 0; i < blocks; ++i)
        add<exact, false>(sums, ignored, places[i], disc, variances, largest);
  }
  result.sums = gathered<double>(sums);
  result.largestReading = root(greatest<double>(largestAngles));
  result.largestResidual = root(greatest<double>(largest) * larger(variances.horizontal, variances.vertical));
}

void solveOne(PlaceEquation* places, const Readings& readings, const Setup& setup,
              const ReadingResiduals& residuals, Outcome<double>& outcome) {
  setup.exact ? solveOneWith<true>(places, readings, setup.variances, residuals, outcome)
              : solveOneWith<false>(places, readings, setup.variances, residuals, outcome);
}

void solveMany(PlaceEquation* places, const double* a, const double* e, std::size_t count, std::size_t fits,
               const Setup& setup, Conclusion<Lanes>* conclusions) {
  setup.exact ? solveManyWith<true>(places, a, e, count, fits, setup, conclusions)
              : solveManyWith<false>(places, a, e, count, fits, setup, conclusions);
}

void sweep(const Readings& readings, const Setup& setup, const Disc<double>& at,
           const ReadingResiduals& residuals, Sweep& result) {
  setup.exact ? sweepWith<true>(readings, setup.variances, at, residuals, result)
              : sweepWith<false>(readings, setup.variances, at, residuals, result);
}

void survey(const Readings& readings, const Setup& setup, const Disc<double>& at, Survey& result) {
  setup.exact ? surveyWith<true>(readings, setup.variances, at, result)
              : surveyWith<false>(readings, setup.variances, at, result);
}

}  // namespace

#ifdef __AVX2__
const ArcKernel wideKernel = {solveOne, solveMany, sweep, survey};
#else
const ArcKernel plainKernel = {solveOne, solveMany, sweep, survey};
#endif

}  // namespace alidade::arc_kernel

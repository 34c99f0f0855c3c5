#include "core/series/shared_causes/series_conclusion.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double namedFrom = 0.8;  // probability: a false alarm of a series is about many sessions

std::vector<EffectBlock> blocksOf(const SharedSet& set) {
  std::vector<EffectBlock> blocks;
  for (const SharedPart& part : set.parts) blocks.push_back(part.block);
  return blocks;
}

bool holds(const SharedSet& set, const EffectBlock& block) {
  return std::ranges::any_of(set.parts, [&](const SharedPart& part) {
    return part.block.effect == block.effect &&
           (part.block.serial == block.serial || part.block.serial.empty() || block.serial.empty());
  });
}

Cause named(const std::string& id) {
  Cause cause;
  cause.effect = id;
  return cause;
}

bool isPartOf(const SharedSet& smaller, const SharedSet& larger) {
  return std::ranges::all_of(smaller.parts,
                             [&](const SharedPart& part) { return holds(larger, part.block); });
}

/// The numbers of an effect, in the units of the catalogue, with the covariance of their weights.
std::vector<CauseParameter> parametersOf(const EffectColumns& columns, const VectorXd& weights,
                                         const MatrixXd& covariance) {
  std::vector<CauseParameter> parameters;
  Index i = 0;
  for (const EffectParameter& parameter : columns.effect->parameters) {
    parameters.push_back({std::string(parameter.name), weights[i] * parameter.plausible,
                          std::sqrt(std::max(covariance(i, i), 0.0)) * parameter.plausible,
                          std::string(parameter.unit)});
    ++i;
  }
  return parameters;
}

/// Of a part in the index-th of its sessions: how its weights hang on z, then how uncertain they are.
MatrixXd covarianceIn(const SharedSet& set, std::size_t p, std::size_t index) {
  const SharedPart& part = set.parts[p];
  Index first = 0;
  for (std::size_t i = 0; i < p; ++i) first += set.parts[i].slope.cols();
  const auto count = static_cast<Index>(part.block.columns().count);
  const Eigen::RowVectorXd features = part.block.featuresOf(index);
  MatrixXd slope = MatrixXd::Zero(count, part.slope.cols());
  for (Index j = 0; j < features.size(); ++j) slope += features[j] * part.slope.middleRows(j * count, count);
  return slope * set.covariance.block(first, first, part.slope.cols(), part.slope.cols()) * slope.transpose();
}

/// Works out what the sets of a search come to.
class Conclusion {
 public:
  Conclusion(const std::vector<SessionEvidence>& evidence, const std::vector<SessionOwners>& owners,
             const std::vector<std::string>& names, const std::vector<std::string>& leftOut,
             const std::stop_token& stop)
      : m_evidence(evidence),
        m_owners(owners),
        m_names(names),
        m_blocks(effectBlocks(owners, leftOut)),
        m_leftOut(leftOut),
        m_stop(stop),
        m_search(m_sums, m_blocks, m_stop) {
    for (const SessionEvidence& session : evidence) m_sums.emplace_back(session);
  }

  SeriesConclusion conclude() {
    search();
    m_best = m_sets.front();
    if (!m_stop.stop_requested()) choose();
    if (!m_stop.stop_requested()) settle();
    SeriesConclusion conclusion;
    SeriesDiagnosis& diagnosis = conclusion.diagnosis;
    for (std::size_t p = 0; p < m_best.parts.size(); ++p)
      std::ranges::move(causesOf(p), std::back_inserter(diagnosis.causes));
    addNoise(diagnosis);
    addOwn(conclusion);
    diagnosis.verdict = verdictOf(diagnosis.causes);
    addSizes(diagnosis);
    addCandidates(diagnosis);
    addWhere(diagnosis);
    addUnseen(diagnosis);
    addAdvice(diagnosis);
    conclusion.known = known();
    return conclusion;
  }

 private:
  const std::vector<SessionEvidence>& m_evidence;
  const std::vector<SessionOwners>& m_owners;
  const std::vector<std::string>& m_names;
  std::vector<SessionSums> m_sums;
  std::vector<EffectBlock> m_blocks;
  const std::vector<std::string>& m_leftOut;
  const std::stop_token& m_stop;
  SharedSearch m_search;
  std::vector<SharedSet> m_sets;
  std::vector<CommonNoise> m_noise;
  SharedSet m_best;
  std::vector<std::vector<SharedRival>> m_rivals;  ///< of each part
  std::vector<std::vector<std::size_t>> m_apart;   ///< of each part

  std::size_t sessions() const { return m_evidence.size(); }

  /// Once with the noise as stated, and again where the sessions of an instrument say that it is larger.
  void search() {
    constexpr double matters = 1.02;
    m_sets = m_search.grown();
    if (m_stop.stop_requested()) return;
    m_noise = commonNoise(m_sums, m_owners, m_sets.front());
    bool again = false;
    for (const CommonNoise& noise : m_noise)
      for (const std::size_t s : noise.sessions) {
        const bool counts = std::ranges::find(m_leftOut, noiseId) == m_leftOut.end();
        if (!counts || noise.scale < matters) continue;
        m_sums[s].scaleNoise(noise.scale);
        again = true;
      }
    if (again) m_sets = m_search.grown();
  }

  double chanceOfAny(const std::vector<EffectBlock>& blocks) const {
    double sum = 0;
    for (const SharedSet& set : m_sets)
      if (std::ranges::any_of(blocks, [&](const EffectBlock& block) { return holds(set, block); }))
        sum += set.chance;
    return std::min(sum, 1.0);
  }

  /// The likeliest set, or a smaller one of the same that is nearly as good; nothing unless something is
  /// likely enough.
  void choose() {
    constexpr double nearlyAsGood = 2;  // natural logarithm
    const auto nothing = std::ranges::find_if(m_sets, [](const SharedSet& set) { return set.parts.empty(); });
    const auto best = std::ranges::find_if(m_sets, [](const SharedSet& set) { return !set.parts.empty(); });
    m_best = *nothing;
    if (best == m_sets.end() || 1 - nothing->chance < namedFrom) return;
    const SharedSet* simplest = &*best;
    for (const SharedSet& other : m_sets)
      if (!other.parts.empty() && other.parts.size() < simplest->parts.size() &&
          other.logPosteriorOdds > best->logPosteriorOdds - nearlyAsGood && isPartOf(other, *best))
        simplest = &other;
    m_best = *simplest;
    // A part that is not likely by itself, with whatever looks like it, is not named.
    for (std::size_t p = 0; p < m_best.parts.size();) {
      std::vector<EffectBlock> group{m_best.parts[p].block};
      for (const auto& [block, odds] : rivalBlocks(p)) group.push_back(block);
      if (chanceOfAny(group) >= namedFrom) {
        ++p;
        continue;
      }
      std::vector<EffectBlock> rest = blocksOf(m_best);
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(p));
      m_best = m_search.madeOf(rest, m_best.accounts);
      p = 0;
    }
  }

  /// Sessions that do not share a part, then whether it drifts, then what looks like it.
  void settle() {
    m_apart.assign(m_best.parts.size(), {});
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) settle(p);
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) {
      m_rivals.emplace_back();
      for (const auto& [block, odds] : rivalBlocks(p))
        m_rivals.back().push_back({std::string(block.columns().effect->id), block.owner, block.serial, odds});
    }
  }

  /// One size with some sessions apart, or one that drifts.
  void settle(std::size_t p) {
    const double better = std::log(3), eachApart = std::log(effectOdds());
    const EffectBlock drift = drifting(ofOneOwner(m_best.parts[p].block), m_owners);
    std::optional<SharedSet> moved;
    if (!drift.sessions.empty()) {
      std::vector<EffectBlock> blocks = blocksOf(m_best);
      blocks[p] = drift;
      moved = m_search.madeOf(blocks, m_best.accounts);
      if (moved->logPosteriorOdds < m_best.logPosteriorOdds + better) moved.reset();
    }
    setApart(p);
    const double apart = m_best.logPosteriorOdds + eachApart * static_cast<double>(m_apart[p].size());
    if (!moved || moved->logPosteriorOdds < apart) return;
    m_best = *std::move(moved);
    m_apart[p].clear();
  }

  /// Of what has a size of its own in each session the same with one size, where all have one owner.
  EffectBlock ofOneOwner(const EffectBlock& block) const {
    if (block.sizes != SizesKind::PerSession) return block;
    const auto same = std::ranges::find_if(m_blocks, [&](const EffectBlock& other) {
      return other.effect == block.effect && other.sizes == SizesKind::One &&
             other.sessions == block.sessions;
    });
    return same == m_blocks.end() ? block : *same;
  }

  /// A session whose own size is out of question beside that of the others does not share the effect; the
  /// worst first.
  void setApart(std::size_t p) {
    constexpr double outOfQuestion = 1e-4;
    constexpr std::size_t fewest = 3;
    if (m_best.parts[p].block.sizes != SizesKind::One ||
        m_best.parts[p].block.columns().effect->response != Response::Linear)
      return;
    while (m_best.parts[p].block.sessions.size() > fewest) {
      const EffectBlock block = m_best.parts[p].block;
      double worst = outOfQuestion / static_cast<double>(block.sessions.size());
      std::optional<std::size_t> who;
      for (std::size_t i = 0; i < block.sessions.size(); ++i) {
        const double tail = agreement(p, i);
        if (tail >= worst) continue;
        worst = tail;
        who = i;
      }
      if (!who) return;
      m_apart[p].push_back(block.sessions[*who]);
      std::vector<EffectBlock> blocks = blocksOf(m_best);
      blocks[p].sessions.erase(blocks[p].sessions.begin() + static_cast<std::ptrdiff_t>(*who));
      m_best = m_search.madeOf(blocks, m_best.accounts);
    }
  }

  /// Chance that a session's own size is as far as it is from that of the others.
  double agreement(std::size_t p, std::size_t index) const {
    const EffectBlock& block = m_best.parts[p].block;
    const std::size_t session = block.sessions[index];
    const SharedSet others =
        m_search.fitted(blocksOf(m_best), m_best.accounts, [&](std::size_t s) { return s != session; });
    const VectorXd expected = others.parts[p].weightsIn(index);
    const MatrixXd normal =
        m_sums[session].normal(m_best.accounts[session], block.columns(), block.columns());
    VectorXd right = m_sums[session].right(m_best.accounts[session], block.columns()) - normal * expected;
    for (std::size_t q = 0; q < others.parts.size(); ++q) {
      const EffectBlock& other = others.parts[q].block;
      const auto found = std::ranges::lower_bound(other.sessions, session);
      if (q == p || found == other.sessions.end() || *found != session) continue;
      right -= m_sums[session].normal(m_best.accounts[session], block.columns(), other.columns()) *
               others.parts[q].weightsIn(static_cast<std::size_t>(found - other.sessions.begin()));
    }
    // N⁻¹ right is how far it is off; it scatters by N⁻¹ + covariance.
    const MatrixXd spread = normal + normal * covarianceIn(others, p, index) * normal;
    const double square = right.dot(spread.completeOrthogonalDecomposition().solve(right));
    return chiSquareUpperTail(square, static_cast<double>(right.size())).value_or(1);
  }

  /// What may stand in the place of a part, the likeliest first, with its odds against it.
  std::vector<std::pair<EffectBlock, double>> rivalBlocks(std::size_t p) const {
    constexpr double close = 0.03, supported = 0.1;
    const SharedPart& part = m_best.parts[p];
    std::vector<EffectBlock> blocks = blocksOf(m_best);
    double noise = 1;
    for (const std::size_t s : part.block.sessions) noise = std::max(noise, m_sums[s].noise());
    std::vector<std::pair<EffectBlock, double>> rivals;
    for (const EffectBlock& block : m_blocks) {
      if (m_stop.stop_requested()) break;
      const bool isOther = std::ranges::none_of(
          m_best.parts, [&](const SharedPart& any) { return any.block.effect == block.effect; });
      // Sizes of its own in each session, or with each owner, take up much; whether they do is for the odds.
      if (!isOther || 2 * block.sessions.size() < part.block.sessions.size()) continue;
      const double difference = m_search.differenceFrom(part, block) / noise;
      if (difference > clearlyToldApart()) continue;
      blocks[p] = block;
      // Weighed last, beside all others, as the part itself is.
      std::vector<EffectBlock> own = blocksOf(m_best);
      std::swap(blocks[p], blocks.back());
      std::swap(own[p], own.back());
      const SharedSet with = m_search.madeOf(blocks, m_best.accounts),
                      as = m_search.madeOf(own, m_best.accounts);
      std::swap(blocks[p], blocks.back());
      if (!(with.parts.back().logGain > supported)) continue;
      const double odds = std::exp(std::min(with.logPosteriorOdds - as.logPosteriorOdds, 10.0));
      const bool isAlike = block.sizes == SizesKind::One && difference < hardlyToldApart();
      if (isAlike || odds > close) rivals.emplace_back(block, odds);
    }
    std::ranges::sort(rivals, [](const auto& a, const auto& b) { return a.second > b.second; });
    return rivals;
  }

  /// A cause for each owner with a size of its own.
  std::vector<SharedCause> causesOf(std::size_t p) const {
    const SharedPart& part = m_best.parts[p];
    const EffectColumns& columns = part.block.columns();
    SharedCause cause;
    cause.cause.effect = columns.effect->id;
    std::vector<EffectBlock> own{part.block};
    cause.cause.probability = chanceOfAny(own);
    cause.owner = part.block.owner;
    cause.rivals = m_rivals[p];
    for (const SharedRival& rival : cause.rivals) {
      std::vector<std::string>& alike = cause.cause.indistinguishableFrom;
      if (std::ranges::find(alike, rival.effect) == alike.end()) alike.push_back(rival.effect);
    }
    cause.isDrifting = part.block.sizes == SizesKind::Drifting;
    cause.apart = m_apart[p];
    const auto parametersIn = [&](std::size_t i) {
      return parametersOf(columns, part.weightsIn(i), covarianceIn(m_best, p, i));
    };
    if (part.block.sizes == SizesKind::PerOwner) return perOwner(cause, p);
    cause.serial = part.block.serial;
    cause.sessions = part.block.sessions;
    if (part.block.sizes == SizesKind::One)
      cause.cause.parameters = parametersIn(0);
    else
      cause.cause.parameters = parametersIn(part.block.sessions.size() - 1);
    if (part.block.sizes != SizesKind::One)
      for (std::size_t i = 0; i < part.block.sessions.size(); ++i)
        cause.sizes.push_back({part.block.sessions[i], parametersIn(i)});
    cause.visibleTogether = m_search.visibleLength(part);
    cause.visibleInOne = cause.visibleTogether / std::sqrt(static_cast<double>(part.block.sessions.size()));
    return {cause};
  }

  std::vector<SharedCause> perOwner(const SharedCause& common, std::size_t p) const {
    const SharedPart& part = m_best.parts[p];
    std::vector<SharedCause> causes;
    for (std::size_t i = 0; i < part.block.sessions.size(); ++i) {
      const std::size_t s = part.block.sessions[i];
      const std::string& serial =
          part.block.owner == CauseOwner::Instrument ? m_owners[s].instrument : m_owners[s].guideway;
      const auto same = std::ranges::find_if(
          causes, [&](const SharedCause& cause) { return !serial.empty() && cause.serial == serial; });
      const double visible = std::pow(m_search.visibleLengthIn(part, i), 2);
      if (same != causes.end()) {
        same->sessions.push_back(s);
        same->visibleTogether += visible;
        continue;
      }
      causes.push_back(common);
      causes.back().serial = serial;
      causes.back().sessions = {s};
      causes.back().visibleTogether = visible;
      causes.back().cause.parameters =
          parametersOf(part.block.columns(), part.weightsIn(i), covarianceIn(m_best, p, i));
    }
    for (SharedCause& cause : causes) {
      cause.visibleTogether = std::sqrt(cause.visibleTogether);
      cause.visibleInOne = cause.visibleTogether / std::sqrt(static_cast<double>(cause.sessions.size()));
    }
    // Those first whose own shows the most; of owners that have next to none of it nothing is said.
    std::ranges::stable_sort(causes, std::greater{}, &SharedCause::visibleTogether);
    constexpr double shows = 2;  // σ
    while (causes.size() > 1 && causes.back().visibleTogether < shows) causes.pop_back();
    return causes;
  }

  void addNoise(SeriesDiagnosis& diagnosis) const {
    for (const CommonNoise& noise : m_noise) {
      if (!noise.isLarger || std::ranges::find(m_leftOut, noiseId) != m_leftOut.end()) continue;
      SharedCause cause;
      cause.cause = named(noiseId);
      cause.cause.probability = noise.probability;
      cause.cause.parameters = {{PHRASE_LATER("Phrase", "ratio"), noise.scale, noise.sigma, "1"}};
      cause.owner = CauseOwner::Instrument;
      cause.serial = noise.instrument;
      cause.sessions = noise.sessions;
      diagnosis.causes.push_back(std::move(cause));
    }
  }

  /// Causes that a session holds by itself.
  void addOwn(SeriesConclusion& conclusion) const {
    conclusion.own.resize(sessions());
    conclusion.ownChance.assign(sessions(), 0);
    for (std::size_t s = 0; s < sessions(); ++s) {
      const std::vector<double> chances = m_search.accountChances(s, m_best);
      double something = 0;
      std::size_t likeliest = 1;
      for (std::size_t k = 1; k < chances.size(); ++k) {
        something += chances[k];
        if (chances[k] > chances[likeliest]) likeliest = k;
      }
      if (something < namedFrom) continue;
      const OwnAccount& account = m_sums[s].account(likeliest);
      std::set<std::string> ids;
      for (const std::string& id : account.causes)
        if (std::ranges::find(diagnosableEffects(), id) != diagnosableEffects().end()) ids.insert(id);
      if (account.noisy) ids.insert(noiseId);
      conclusion.ownChance[s] = something;
      for (const std::string& id : ids) {
        conclusion.own[s].push_back(id);
        SharedCause cause;
        const auto same = std::ranges::find(m_evidence[s].causes, id, &Cause::effect);
        cause.cause = same != m_evidence[s].causes.end() ? *same : named(id);
        cause.cause.probability = something;
        cause.sessions = {s};
        conclusion.diagnosis.causes.push_back(std::move(cause));
      }
    }
  }

  static DiagnosisVerdict verdictOf(const std::vector<SharedCause>& causes) {
    if (causes.empty()) return DiagnosisVerdict::WithinNoise;
    if (causes.size() > 1) return DiagnosisVerdict::SeveralCauses;
    return causes.front().cause.indistinguishableFrom.empty() ? DiagnosisVerdict::SingleCause
                                                              : DiagnosisVerdict::Ambiguous;
  }

  /// Σ of the squared circle residuals, arcseconds, with the sizes of a set taken off.
  double circleSquares(std::size_t s, const SharedSet& set) const {
    double squares = m_evidence[s].circleSquares;
    std::vector<std::pair<const EffectColumns*, VectorXd>> shares;
    for (const SharedPart& part : set.parts) {
      const auto found = std::ranges::lower_bound(part.block.sessions, s);
      if (found == part.block.sessions.end() || *found != s) continue;
      shares.emplace_back(&part.block.columns(),
                          part.weightsIn(static_cast<std::size_t>(found - part.block.sessions.begin())));
    }
    for (const auto& [a, x] : shares) {
      squares -= 2 * x.dot(Eigen::Map<const VectorXd>(&m_evidence[s].circleRight[a->first], x.size()));
      for (const auto& [b, y] : shares) squares += x.dot(blockOf(m_evidence[s].circleNormal, *a, *b) * y);
    }
    return std::max(squares, 0.0);
  }

  /// Each fold's sessions by the sizes that the others have; few sessions are each a fold.
  std::vector<SharedSet> foldsOf() const {
    std::vector<SharedSet> folds;
    for (std::size_t fold = 0; fold < foldCount(); ++fold)
      folds.push_back(m_search.fitted(blocksOf(m_best), m_best.accounts,
                                      [&](std::size_t s) { return s % foldCount() != fold; }));
    return folds;
  }
  std::size_t foldCount() const {
    constexpr std::size_t mostFolds = 20;
    return std::min(sessions(), mostFolds);
  }

  void addSizes(SeriesDiagnosis& diagnosis) const {
    double before = 0, after = 0, heldOut = 0, chiBefore = 0, chiAfter = 0, f = 0, fAfter = 0;
    std::size_t readings = 0;
    const std::vector<SharedSet> folds = foldsOf();
    for (std::size_t s = 0; s < sessions(); ++s) {
      readings += m_evidence[s].circleReadings;
      before += m_evidence[s].circleSquares;
      after += circleSquares(s, m_best);
      heldOut += circleSquares(s, folds[s % foldCount()]);
      const OwnAccount& account = m_sums[s].account(m_best.accounts[s]);
      const double noise = std::max(m_sums[s].noise(), account.noise);
      chiBefore += m_evidence[s].chiSquare;
      chiAfter += chiSquareLeft(m_sums[s], s, m_best) / (noise * noise);
      f += m_evidence[s].degreesOfFreedom;
      fAfter += std::max(0, m_evidence[s].degreesOfFreedom - static_cast<int>(account.directions));
    }
    for (const SharedPart& part : m_best.parts) fAfter -= static_cast<double>(part.slope.cols());
    const auto sizeOf = [&](double squares, double chiSquare, double freedom) {
      GapSize size{.rms = readings > 0 ? std::sqrt(squares / static_cast<double>(readings)) : 0};
      if (const auto tail = chiSquareUpperTail(chiSquare, freedom)) {
        size.reducedChiSquare = chiSquare / freedom;
        size.pValue = *tail;
      }
      return size;
    };
    diagnosis.gap = sizeOf(before, chiBefore, f);
    diagnosis.after = sizeOf(after, chiAfter, fAfter);
    if (before > 0) diagnosis.shrink.inSample = 1 - std::sqrt(after / before);
    if (chiBefore > f)
      diagnosis.shrink.ofExcess = std::clamp(1 - (chiAfter - fAfter) / (chiBefore - f), 0.0, 1.0);
    diagnosis.shrink.heldOut = sessions() < 2 || !(before > 0) ? std::numeric_limits<double>::quiet_NaN()
                               : m_best.parts.empty()          ? 0
                                                               : 1 - std::sqrt(heldOut / before);
  }

  void addCandidates(SeriesDiagnosis& diagnosis) const {
    for (const EffectBlock& block : m_blocks) {
      if (m_stop.stop_requested()) return;
      if (block.sizes != SizesKind::One && block.owner != CauseOwner::Time) continue;
      const ColumnGain gain = m_search.alone(block);
      const SharedSet set = m_search.fitted({block}, std::vector<std::size_t>(sessions(), 0));
      const Candidate candidate{std::string(block.columns().effect->id), gain.log,
                                m_search.visibleLength(set.parts.front())};
      const auto same = std::ranges::find(diagnosis.candidates, candidate.effect, &Candidate::effect);
      if (same == diagnosis.candidates.end())
        diagnosis.candidates.push_back(candidate);
      else if (same->logBayesFactor < candidate.logBayesFactor)
        *same = candidate;
    }
    std::ranges::sort(diagnosis.candidates, std::greater{}, &Candidate::logBayesFactor);
  }

  void addWhere(SeriesDiagnosis& diagnosis) const {
    double left = 0, own = 0;
    std::map<std::string, double> ofInstruments, ofGuideways;
    std::vector<double> excess;
    for (std::size_t s = 0; s < sessions(); ++s) {
      const double f = m_evidence[s].degreesOfFreedom;
      const OwnAccount& account = m_sums[s].account(m_best.accounts[s]);
      excess.push_back(std::max(0.0, m_evidence[s].chiSquare - f));
      ofInstruments[m_owners[s].instrument] += excess.back();
      ofGuideways[m_owners[s].guideway] += excess.back();
      left += chiSquareLeft(m_sums[s], s, m_best) - f + static_cast<double>(account.directions);
      own += m_evidence[s].chiSquare - account.chiSquare;
    }
    std::map<CauseOwner, double> frames;
    for (const SharedPart& part : m_best.parts)
      frames[part.block.owner] += std::pow(m_search.visibleLength(part), 2);
    frames[CauseOwner::Time] += std::max(own, 0.0);
    const double noise = std::max(left, 0.0);
    double sum = noise;
    for (const auto& [owner, size] : frames) sum += size;
    const auto share = [&](const std::string& by, const std::string& of, double size, double whole) {
      diagnosis.where.push_back({by, of, whole > 0 ? size / whole : 0});
    };
    for (const CauseOwner owner : {CauseOwner::Guideway, CauseOwner::Instrument, CauseOwner::Time})
      share("frame", std::string(nameOf(owner)), frames[owner], sum);
    share("frame", "noise", sum > 0 ? noise : 1, sum > 0 ? sum : 1);
    const double whole = std::accumulate(excess.begin(), excess.end(), 0.0);
    for (std::size_t s = 0; s < sessions(); ++s) share("session", m_names[s], excess[s], whole);
    for (const auto& [serial, size] : ofInstruments)
      if (!serial.empty()) share("instrument", serial, size, whole);
    for (const auto& [serial, size] : ofGuideways)
      if (!serial.empty()) share("guideway", serial, size, whole);
  }

  /// What would move Δd, the mean of the sessions, and shows in none of them nor in all together.
  void addUnseen(SeriesDiagnosis& diagnosis) const {
    constexpr double negligible = 1e-3;  // mm
    for (const EffectColumns& columns : effectColumns()) {
      if (columns.effect->response == Response::AllOrNothing) continue;
      if (std::ranges::find(m_leftOut, columns.effect->id) != m_leftOut.end()) continue;
      const auto count = static_cast<Index>(columns.effect->parameters.size());
      VectorXd influence = VectorXd::Zero(count);
      MatrixXd normal = MatrixXd::Zero(static_cast<Index>(columns.count), static_cast<Index>(columns.count));
      for (std::size_t s = 0; s < sessions(); ++s) {
        influence += Eigen::Map<const VectorXd>(&m_evidence[s].influence[columns.first], count) /
                     static_cast<double>(sessions());
        normal += m_sums[s].plainNormal(columns, columns);
      }
      const double moves = influence.norm();
      if (!(moves > negligible)) continue;
      const VectorXd along = influence / moves;
      VectorXd weights = VectorXd::Zero(normal.cols());
      weights.head(count) = along;
      if (columns.effect->response == Response::Bent)
        weights.tail(3) << along[0] * along[0] / 2, along[0] * along[1], along[1] * along[1] / 2;
      const double visible = std::sqrt(std::max(weights.dot(normal * weights), 0.0));
      if (visible < clearlyToldApart())
        diagnosis.unseen.push_back({std::string(columns.effect->id), moves, visible});
    }
    std::ranges::sort(diagnosis.unseen, std::greater{}, &UnseenEffect::influence);
  }

  /// Sessions until something that shows by `inOne` each is clear.
  static int sessionsFor(double inOne) {
    constexpr double most = 99;
    return static_cast<int>(
        std::clamp(std::ceil(std::pow(clearlyToldApart() / std::max(inOne, 1e-9), 2)), 1.0, most));
  }

  void addAdvice(SeriesDiagnosis& diagnosis) const {
    const auto serialsOf = [&](CauseOwner kind) {
      std::vector<std::string> serials;
      for (const SessionOwners& owner : m_owners) {
        const std::string& serial = kind == CauseOwner::Instrument ? owner.instrument : owner.guideway;
        if (!serial.empty() && std::ranges::find(serials, serial) == serials.end()) serials.push_back(serial);
      }
      return serials;
    };
    const auto add = [&](const SharedCause& cause, const std::string& rival, CauseOwner changed) {
      SeriesAdvice advice;
      advice.what = changed == CauseOwner::Instrument ? SeriesAdvice::What::OtherInstrument
                                                      : SeriesAdvice::What::OtherGuideway;
      const SessionOwners& now = m_owners[cause.sessions.front()];
      const auto others = serialsOf(changed);
      const std::string& present = changed == CauseOwner::Instrument ? now.instrument : now.guideway;
      const auto other = std::ranges::find_if(others, [&](const std::string& s) { return s != present; });
      const std::string chosen = other == others.end() ? "" : *other;
      advice.instrument = changed == CauseOwner::Instrument ? chosen : now.instrument;
      advice.guideway = changed == CauseOwner::Instrument ? now.guideway : chosen;
      advice.separates = {cause.cause.effect, rival};
      advice.sessions = sessionsFor(cause.visibleInOne);
      advice.bySigma = cause.visibleInOne * std::sqrt(advice.sessions);
      diagnosis.advice.push_back(std::move(advice));
    };
    for (const SharedCause& cause : diagnosis.causes) {
      if (cause.owner == CauseOwner::Time || !(cause.visibleInOne > 0)) continue;
      const auto rival = std::ranges::find_if(cause.rivals, [&](const SharedRival& other) {
        return other.owner != cause.owner && other.owner != CauseOwner::Time;
      });
      if (rival == cause.rivals.end()) continue;
      add(cause, rival->effect, CauseOwner::Instrument);
      add(cause, rival->effect, CauseOwner::Guideway);
    }
    const bool isShared = std::ranges::any_of(
        diagnosis.causes, [](const SharedCause& cause) { return cause.owner != CauseOwner::Time; });
    if (isShared || m_sets.empty()) return;
    addMore(diagnosis);
  }

  /// Something may be there, but it shows too faintly so far.
  void addMore(SeriesDiagnosis& diagnosis) const {
    constexpr double likely = 0.2, clear = 6;  // probability; σ together from which a cause is named
    const auto best = std::ranges::find_if(m_sets, [](const SharedSet& set) { return !set.parts.empty(); });
    if (best == m_sets.end() || best->chance < likely) return;
    const SharedPart& part = best->parts.front();
    const double together = m_search.visibleLength(part);
    const double inOne = together / std::sqrt(static_cast<double>(part.block.sessions.size()));
    if (part.block.owner == CauseOwner::Time || !(inOne > 0) || together >= clear) return;
    SeriesAdvice advice;
    if (part.block.owner == CauseOwner::Instrument) advice.instrument = part.block.serial;
    if (part.block.owner == CauseOwner::Guideway) advice.guideway = part.block.serial;
    advice.separates = {std::string(part.block.columns().effect->id)};
    advice.sessions = static_cast<int>(
        std::clamp(std::ceil((clear * clear - together * together) / (inOne * inOne)), 1.0, 99.0));
    advice.bySigma = std::sqrt(together * together + advice.sessions * inOne * inOne);
    diagnosis.advice.push_back(std::move(advice));
  }

  /// What the sessions of other folds say of the effects that each shares.
  std::vector<std::vector<KnownNumber>> known() const {
    std::vector<std::vector<KnownNumber>> known(sessions());
    const std::vector<SharedSet> folds = foldsOf();
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) {
      const EffectBlock& block = m_best.parts[p].block;
      const Effect& effect = *block.columns().effect;
      if (block.sizes == SizesKind::PerSession || effect.response == Response::AllOrNothing) continue;
      for (std::size_t i = 0; i < block.sessions.size(); ++i) {
        const std::size_t s = block.sessions[i];
        const SharedSet& others = folds[s % foldCount()];
        for (const CauseParameter& parameter :
             parametersOf(block.columns(), others.parts[p].weightsIn(i), covarianceIn(others, p, i)))
          known[s].push_back({.where = {},
                              .effect = std::string(effect.id),
                              .parameter = effect.parameters.size() > 1 ? parameter.name : "",
                              .unit = parameter.unit,
                              .from = Phrase::of("the other sessions of the series"),
                              .value = parameter.value,
                              .sigma = parameter.sigma});
      }
    }
    return known;
  }
};

}  // namespace

SeriesConclusion concludeSeries(const std::vector<SessionEvidence>& evidence,
                                const std::vector<SessionOwners>& owners,
                                const std::vector<std::string>& names,
                                const std::vector<std::string>& leftOut, const std::stop_token& stop) {
  return Conclusion(evidence, owners, names, leftOut, stop).conclude();
}

}  // namespace alidade

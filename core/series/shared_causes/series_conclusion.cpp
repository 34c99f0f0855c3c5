#include "core/series/shared_causes/series_conclusion.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"
#include "core/series/shared_causes/searched_series.h"
#include "core/session/own_effects.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double namedFrom = 0.8;  // probability; high, as a false alarm of a series concerns many sessions

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

bool isPartOf(const SharedSet& smaller, const SharedSet& larger) {
  return std::ranges::all_of(smaller.parts,
                             [&](const SharedPart& part) { return holds(larger, part.block); });
}

/// The parameters of an effect, in catalogue units, with u from the covariance of its weights.
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

/// Covariance of the weights of part `p` in the session with this index, propagated from that of z.
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

/// Derives the conclusion from the sets of a search.
class Conclusion {
 public:
  Conclusion(const std::vector<SessionEvidence>& evidence, const std::vector<SessionOwners>& owners,
             const std::vector<std::string>& names, const std::vector<std::string>& leftOut,
             const std::stop_token& stop)
      : m_evidence(evidence),
        m_owners(owners),
        m_names(names),
        m_blocks(effectBlocks(*evidence.front().columns, owners, leftOut)),
        m_leftOut(leftOut),
        m_stop(stop),
        m_search(m_sums, m_blocks, m_stop) {
    for (const SessionEvidence& session : evidence) m_sums.emplace_back(session);
  }

  SeriesConclusion conclude() {
    search();
    m_best = m_sets.front();
    if (!m_stop.stop_requested()) choose();
    if (!m_stop.stop_requested()) refine();
    SeriesConclusion conclusion;
    SeriesDiagnosis& diagnosis = conclusion.diagnosis;
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) {
      if (m_best.parts[p].block.isPattern())
        diagnosis.pattern = patternOf(m_best.parts[p]);
      else
        std::ranges::move(causesOf(p), std::back_inserter(diagnosis.causes));
    }
    addNoise(conclusion);
    addOwn(conclusion);
    diagnosis.unknownChance = chanceOfPattern();
    if (!diagnosis.pattern) diagnosis.pattern = patternOfMost();
    diagnosis.verdict = diagnosis.pattern ? DiagnosisVerdict::NotInCatalogue : verdictOf(diagnosis.causes);
    addSizes(diagnosis);
    const SearchedSeries searched{m_evidence, m_owners, m_names,  m_leftOut, m_stop,
                                  m_sums,     m_blocks, m_search, m_sets,    m_best};
    addCandidates(diagnosis, searched);
    addWhere(diagnosis, searched);
    addUndetectable(diagnosis, searched);
    addAdvice(diagnosis, searched);
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
  std::vector<std::vector<SharedRival>> m_rivals;  ///< for each part
  std::vector<std::vector<std::size_t>> m_apart;   ///< for each part

  std::size_t sessions() const { return m_evidence.size(); }

  /// Searches with the stated noise, and again if the sessions of an instrument show larger noise.
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

  double chanceOfPattern() const {
    double sum = 0;
    for (const SharedSet& set : m_sets)
      if (set.isShaped()) sum += set.chance;
    return std::min(sum, 1.0);
  }

  /// Chooses the likeliest set, or a smaller subset that is nearly as good. Chooses the empty set if no set
  /// is likely enough. An uncatalogued pattern is included if it is likelier than all catalogued effects.
  void choose() {
    const auto nothing = std::ranges::find_if(m_sets, [](const SharedSet& set) { return set.parts.empty(); });
    const double unknown = chanceOfPattern();
    const bool isUnknown = unknown > 1 - nothing->chance - unknown;
    const auto best = std::ranges::find_if(m_sets, [&](const SharedSet& set) {
      return isUnknown ? set.isShaped() : !set.parts.empty() && !set.isShaped();
    });
    m_best = *nothing;
    if (best == m_sets.end() || 1 - nothing->chance < namedFrom) return;
    const SharedSet* simplest = &*best;
    const double enough = isUnknown ? thresholds.certain : namedFrom;
    for (const SharedSet& other : m_sets)
      if (!other.parts.empty() && other.isShaped() == isUnknown &&
          other.parts.size() < simplest->parts.size() &&
          other.logPosteriorOdds > best->logPosteriorOdds - thresholds.nearlyAsGood && isPartOf(other, *best))
        simplest = &other;
    m_best = *simplest;
    // Drops a part that, together with its look-alikes, is not likely enough to be named.
    for (std::size_t p = 0; p < m_best.parts.size();) {
      if (m_best.parts[p].block.isPattern()) {
        ++p;
        continue;
      }
      std::vector<EffectBlock> group{m_best.parts[p].block};
      for (const auto& [block, odds] : rivalBlocks(p)) group.push_back(block);
      if (chanceOfAny(group) >= enough) {
        ++p;
        continue;
      }
      std::vector<EffectBlock> rest = blocksOf(m_best);
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(p));
      m_best = m_search.madeOf(rest, m_best.explanations);
      p = 0;
    }
  }

  /// Determines for each part which sessions lack it, whether it drifts, and which its look-alikes are.
  void refine() {
    m_apart.assign(m_best.parts.size(), {});
    for (std::size_t p = 0; p < m_best.parts.size(); ++p)
      if (!m_best.parts[p].block.isPattern()) refine(p);
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) {
      m_rivals.emplace_back();
      if (m_best.parts[p].block.isPattern()) continue;
      for (const auto& [block, odds] : rivalBlocks(p))
        if (!block.isPattern())
          m_rivals.back().push_back(
              {std::string(block.columns().effect->id), block.owner, block.serial, odds});
    }
  }

  /// Chooses between one size with some sessions excluded and a drifting size.
  void refine(std::size_t p) {
    const double better = std::log(3), eachApart = std::log(effectOdds());
    const EffectBlock drift = drifting(ofOneOwner(m_best.parts[p].block), m_owners);
    std::optional<SharedSet> moved;
    if (!drift.sessions.empty()) {
      std::vector<EffectBlock> blocks = blocksOf(m_best);
      blocks[p] = drift;
      moved = m_search.madeOf(blocks, m_best.explanations);
      if (moved->logPosteriorOdds < m_best.logPosteriorOdds + better) moved.reset();
    }
    setApart(p);
    const double apart = m_best.logPosteriorOdds + eachApart * static_cast<double>(m_apart[p].size());
    if (!moved || moved->logPosteriorOdds < apart) return;
    m_best = *std::move(moved);
    m_apart[p].clear();
  }

  /// The block with one size instead of one per session, if all sessions have one owner.
  EffectBlock ofOneOwner(const EffectBlock& block) const {
    if (block.sizes != SizesKind::PerSession) return block;
    const auto same = std::ranges::find_if(m_blocks, [&](const EffectBlock& other) {
      return other.effect == block.effect && other.sizes == SizesKind::One &&
             other.sessions == block.sessions;
    });
    return same == m_blocks.end() ? block : *same;
  }

  /// Excludes sessions whose own size clearly contradicts the size of the others, the worst first.
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
      m_best = m_search.madeOf(blocks, m_best.explanations);
    }
  }

  /// Probability that chance separates a session's own size at least this far from the size in the others.
  double agreement(std::size_t p, std::size_t index) const {
    const EffectBlock& block = m_best.parts[p].block;
    const std::size_t session = block.sessions[index];
    const SharedSet others =
        m_search.fitted(blocksOf(m_best), m_best.explanations, [&](std::size_t s) { return s != session; });
    const VectorXd expected = others.parts[p].weightsIn(index);
    const MatrixXd normal =
        m_sums[session].normal(m_best.explanations[session], block.columns(), block.columns());
    VectorXd right = m_sums[session].right(m_best.explanations[session], block.columns()) - normal * expected;
    for (std::size_t q = 0; q < others.parts.size(); ++q) {
      const EffectBlock& other = others.parts[q].block;
      const auto found = std::ranges::lower_bound(other.sessions, session);
      if (q == p || found == other.sessions.end() || *found != session) continue;
      right -= m_sums[session].normal(m_best.explanations[session], block.columns(), other.columns()) *
               others.parts[q].weightsIn(static_cast<std::size_t>(found - other.sessions.begin()));
    }
    // With N = `normal`, N⁻¹ right is the difference of the sizes; the covariances of both sizes add up.
    const MatrixXd spread = normal + normal * covarianceIn(others, p, index) * normal;
    const double square = right.dot(spread.completeOrthogonalDecomposition().solve(right));
    return chiSquareUpperTail(square, static_cast<double>(right.size())).value_or(1);
  }

  /// The blocks that may replace a part, the likeliest first, each with its odds against the part.
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
      if (!isOther || (block.isPattern() && m_best.isShaped())) continue;
      if (2 * block.sessions.size() < part.block.sessions.size()) continue;
      const double difference = m_search.differenceFrom(part, block) / noise;
      if (difference > clearlySeparated()) continue;
      blocks[p] = block;
      // For a fair comparison, the block and the part are each added last to the other parts.
      std::vector<EffectBlock> own = blocksOf(m_best);
      std::swap(blocks[p], blocks.back());
      std::swap(own[p], own.back());
      const SharedSet with = m_search.madeOf(blocks, m_best.explanations),
                      as = m_search.madeOf(own, m_best.explanations);
      std::swap(blocks[p], blocks.back());
      if (!(with.parts.back().logGain > supported)) continue;
      const double odds = std::exp(std::min(with.logPosteriorOdds - as.logPosteriorOdds, 10.0));
      // A block with a size per session or owner fits almost any trace; only its odds count.
      const bool isAlike = block.sizes == SizesKind::One && difference < hardlySeparated();
      if (isAlike || odds > close) rivals.emplace_back(block, odds);
    }
    std::ranges::sort(rivals, [](const auto& a, const auto& b) { return a.second > b.second; });
    return rivals;
  }

  /// The most frequent pattern, if more than half of the sessions, and at least two, each have an
  /// uncatalogued pattern of their own.
  std::optional<SharedPattern> patternOfMost() const {
    SharedPattern pattern{.follows = {}, .probability = 1, .isOfEach = true};
    std::map<std::string, std::size_t> counts;
    for (std::size_t s = 0; s < sessions(); ++s) {
      double chance = 0, most = 0;
      std::string follows;
      const std::vector<double> chances = m_search.explanationChances(s, m_best);
      for (std::size_t k = 1; k < chances.size(); ++k) {
        const std::string own = shapeIn(m_sums[s].explanation(k));
        if (own.empty()) continue;
        chance += chances[k];
        if (chances[k] > most) follows = own;
        most = std::max(most, chances[k]);
      }
      if (chance < namedFrom) continue;
      pattern.sessions.push_back(s);
      pattern.probability = std::min(pattern.probability, chance);
      ++counts[follows];
    }
    if (pattern.sessions.size() < 2 || 2 * pattern.sessions.size() <= sessions()) return std::nullopt;
    pattern.follows = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; })->first;
    return pattern;
  }

  /// Returns the id of the pattern among the causes of an explanation; empty without a pattern.
  static std::string shapeIn(const SessionExplanation& explanation) {
    for (const std::string& id : explanation.causes)
      if (!isCause(id)) return id;
    return {};
  }

  static bool isCause(const std::string& id) {
    return id.starts_with(ownPrefix) ||
           std::ranges::find(diagnosableEffects(), id) != diagnosableEffects().end();
  }

  SharedPattern patternOf(const SharedPart& part) const {
    const double together = m_search.visibleLength(part);
    double excess = 1e-9;
    for (const SessionEvidence& session : m_evidence) excess += session.chiSquare - session.degreesOfFreedom;
    return {.follows = std::string(part.block.columns().effect->id),
            .order = part.block.columns().order,
            .share = together * together / std::max(excess, together * together),
            .owner = part.block.owner,
            .serial = part.block.serial,
            .sessions = part.block.sessions,
            .probability = chanceOfPattern(),
            .visibleInOne = together / std::sqrt(static_cast<double>(part.block.sessions.size())),
            .visibleTogether = together};
  }

  /// The causes of a part: one for each owner with a size of its own.
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
    if (part.block.sizes != SizesKind::PerSession)
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
    // The most visible first; owners whose share hardly shows are omitted.
    std::ranges::stable_sort(causes, std::greater{}, &SharedCause::visibleTogether);
    constexpr double shows = 2;  // σ
    while (causes.size() > 1 && causes.back().visibleTogether < shows) causes.pop_back();
    return causes;
  }

  void addNoise(SeriesConclusion& conclusion) const {
    for (const CommonNoise& noise : m_noise) {
      if (!noise.isLarger || std::ranges::find(m_leftOut, noiseId) != m_leftOut.end()) continue;
      SharedCause cause;
      cause.cause = Cause{.effect = noiseId};
      cause.cause.probability = noise.probability;
      cause.cause.parameters = {{PHRASE_LATER("Phrase", "ratio"), noise.scale, noise.sigma, "1"}};
      cause.owner = noise.isOfOne ? CauseOwner::Time : CauseOwner::Instrument;
      if (!noise.isOfOne) cause.serial = noise.instrument;
      cause.sessions = noise.sessions;
      conclusion.diagnosis.causes.push_back(std::move(cause));
    }
  }

  /// Adds the causes that each session has of its own.
  void addOwn(SeriesConclusion& conclusion) const {
    conclusion.own.resize(sessions());
    conclusion.ownChance.assign(sessions(), 0);
    for (const CommonNoise& noise : m_noise)
      if (noise.isOfOne && noise.isLarger) {
        conclusion.own[noise.sessions.front()].emplace_back(noiseId);
        conclusion.ownChance[noise.sessions.front()] = noise.probability;
      }
    for (std::size_t s = 0; s < sessions(); ++s) {
      const std::vector<double> chances = m_search.explanationChances(s, m_best);
      double something = 0;
      std::size_t likeliest = 1;
      for (std::size_t k = 1; k < chances.size(); ++k) {
        something += chances[k];
        if (chances[k] > chances[likeliest]) likeliest = k;
      }
      if (something < namedFrom) continue;
      const SessionExplanation& explanation = m_sums[s].explanation(likeliest);
      std::set<std::string> ids;
      for (const std::string& id : explanation.causes)
        if (isCause(id)) ids.insert(id);
      if (explanation.noisy) ids.insert(noiseId);
      conclusion.ownChance[s] = something;
      for (const std::string& id : ids) {
        conclusion.own[s].push_back(id);
        SharedCause cause;
        const auto same = std::ranges::find(m_evidence[s].causes, id, &Cause::effect);
        cause.cause = same != m_evidence[s].causes.end() ? *same : Cause{.effect = id};
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

  /// Sum of the squared circle residuals, arcsec², after subtracting the effects of a set.
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
      for (const auto& [b, y] : shares)
        squares += x.dot(blockOf(*m_evidence[s].columns, m_evidence[s].circleNormal, *a, *b) * y);
    }
    return std::max(squares, 0.0);
  }

  /// For each fold, the set fitted without the sessions of the fold. There are at most 20 folds.
  std::vector<SharedSet> foldsOf() const {
    std::vector<SharedSet> folds;
    for (std::size_t fold = 0; fold < foldCount(); ++fold)
      folds.push_back(m_search.fitted(blocksOf(m_best), m_best.explanations,
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
      const SessionExplanation& explanation = m_sums[s].explanation(m_best.explanations[s]);
      const double noise = std::max(m_sums[s].noise(), explanation.noise);
      chiBefore += m_evidence[s].chiSquare;
      chiAfter += chiSquareLeft(m_sums[s], s, m_best) / (noise * noise);
      f += m_evidence[s].degreesOfFreedom;
      fAfter += std::max(0, m_evidence[s].degreesOfFreedom - static_cast<int>(explanation.directions));
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

  /// For each session, the sizes of its shared effects, fitted to the sessions of the other folds.
  std::vector<std::vector<KnownNumber>> known() const {
    std::vector<std::vector<KnownNumber>> known(sessions());
    const std::vector<SharedSet> folds = foldsOf();
    for (std::size_t p = 0; p < m_best.parts.size(); ++p) {
      const EffectBlock& block = m_best.parts[p].block;
      const Effect& effect = *block.columns().effect;
      if (block.isPattern() || block.sizes == SizesKind::PerSession ||
          effect.response == Response::AllOrNothing)
        continue;
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

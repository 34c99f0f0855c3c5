#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/arc/published_fit.h"
#include "core/adjustment/result/acceptance.h"
#include "core/adjustment/result/fit_finding.h"
#include "core/adjustment/result/intersection.h"
#include "core/session/measurement.h"

namespace alidade {

/// An estimated parameter of an effect, in the unit of the catalogue.
struct EffectEstimate {
  std::string effect, name, unit;
  double value = 0, sigma = 0;
};

/// The arcs fitted rigorously, their intersection, and findings on the data. A plain value: computed from a
/// measurement, shown by console, window and report.
struct SessionFit {
  std::vector<ArcFit> arcs;        ///< the arcs that could be fitted, in the measurement's order
  JointFit joint;                  ///< of all fitted arcs together; empty without arcs
  std::vector<ArcSigma> sigmas;    ///< of each arc, scaled by s0
  std::vector<ArcBudget> budgets;  ///< of each arc, from which `sigmas` follow
  NoiseScale noise;                ///< s0, common to all arcs
  std::optional<Intersection> intersection;
  std::vector<EffectEstimate> effects;
  /// The reason why the lengths allow no verdict (`doubtfulLengths`); empty if they are not in doubt.
  std::optional<LengthsInDoubt> lengthsInDoubt;
  std::optional<Verdict> verdict;    ///< absent without Δd or tolerance; undecided with lengths in doubt
  std::vector<FitFinding> findings;  ///< of the arcs and of the session; an Error explains a missing result

  const ArcFit* arcAt(int axisDeg) const;                   ///< the first at this axis; null if there is none
  const ArcFit* arcOfPosition(std::size_t position) const;  ///< null if there is none
};

/// Fits every arc that its readings determine by `fitArc`, then all of them together by `fitJointly`. The
/// joint fit includes the slider readings and the effects that the session's model names. Example:
/// samples/programs/fit.cpp.
SessionFit fitSession(const Measurement& measurement);

/// The measurement with only the fitted arcs, whose indices `SessionFit::joint` uses.
Measurement fittedPart(const Measurement& measurement, const SessionFit& fit);

/// The error terms of the effects that the measurement's model names, each with its plausible size as prior.
std::vector<EstimatedTerm> estimatedTerms(const Measurement& measurement);

/// The published method on each arc, for comparison; for a repeated axis Δd uses the mean centre.
struct PublishedSessionFit {
  std::vector<PublishedFit> arcs;
  std::optional<double> intersection;           ///< Δd, y up, mm
  std::optional<double> intersectionAsPrinted;  ///< (Δy − Δy′)/2 in the paper's signs
  double inPlane = 0;                           ///< |O1 − O2|/2, mm; with an intersection
  std::vector<FitFinding> findings;
};

PublishedSessionFit fitSessionAsPublished(const Measurement& measurement);

}  // namespace alidade

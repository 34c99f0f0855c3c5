#pragma once

#include <string>
#include <vector>

#include "core/adjustment/arc/arc_fault.h"
#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/fit_finding.h"
#include "core/base/finding.h"

namespace alidade {

/// Converts the findings of a fit to sentences.
Finding inWords(const FitFinding& finding);
std::vector<Finding> inWords(const std::vector<FitFinding>& findings);

/// Also converts the suspects, if there are any, to one finding, which comes first.
std::vector<Finding> inWords(const std::vector<FitFinding>& findings, const std::vector<Suspect>& suspects);

/// A finding, and what to do about it; whole sentences.
struct Words {
  std::string text;
  std::string remedy = {};  ///< may be empty
};

/// The predicate of a sentence about an arc, "has readings of 2 places; a circle …", without a full stop.
std::string textOf(const ArcFault& fault);

// One function for each kind of finding; `inWords` calls them.

/// "0°: the readings scatter 7.3 times their stated noise …".
Words wordsOf(const ArcFinding& finding);

Words wordsOf(const session_finding::ArcMissing& finding);
Words wordsOf(const session_finding::Undetermined& finding);
Words wordsOf(const session_finding::PositionMissing& finding);
Words wordsOf(const session_finding::RadiiDiffer& finding);
Words wordsOf(const session_finding::CentresDiffer& finding);
Words wordsOf(const session_finding::KnownRadiusContradicted& finding);
Words wordsOf(const session_finding::NominalRadiusContradicted& finding);
Words wordsOf(const session_finding::PositionCopied& finding);
Words wordsOf(const session_finding::UnknownEffect& finding);
Words wordsOf(const session_finding::KnownOfNothing& finding);
Words wordsOf(const session_finding::CorrectionsDiffer& finding);
Words wordsOf(const session_finding::TiltsUnused& finding);
Words wordsOf(const session_finding::AxisMoved& finding);
Words wordsOf(const session_finding::CompensatorOff& finding);
Words wordsOf(const session_finding::PlanarRelation& finding);

Words wordsOf(const setup_finding::DistanceTooShort& finding);
Words wordsOf(const setup_finding::PlacesOnTheWrongSide& finding);
Words wordsOf(const setup_finding::ZeroOfOtherCircle& finding);
Words wordsOf(const setup_finding::SlidersDiffer& finding);
Words wordsOf(const setup_finding::ZerosAlike& finding);
Words wordsOf(const setup_finding::ZerosDiffer& finding);
Words wordsOf(const setup_finding::ReadingsRounded& finding);
Words wordsOf(const setup_finding::ZeroMoved& finding);
Words wordsOf(const setup_finding::ZeroFaceLeftOut& finding);

/// "the distance L (2400) and the nominal radius R0 (1000), both in mm": the object of "Check".
std::string lengthsToCheck(double distance, double nominalRadius);

/// Joins two sentences; either may be empty.
std::string inTurn(const std::string& first, const std::string& second);

/// The sentences of a finding, its remedy last.
inline std::string sentencesOf(const Finding& finding) {
  return inTurn(finding.text, finding.remedy);
}

}  // namespace alidade

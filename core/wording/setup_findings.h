#pragma once

#include <string>

#include "core/adjustment/result/fit_finding.h"
#include "core/wording/words.h"

namespace alidade {

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

}  // namespace alidade

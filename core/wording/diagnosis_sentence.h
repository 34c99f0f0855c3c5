#pragma once

#include <string>

#include "core/base/problem.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"

namespace alidade {

/// The name of the pattern in a gap without a cause: "vertical readings varying with azimuth".
std::string patternName(const GapShape& shape);

/// The verdict in a few words: "One cause: collimation".
std::string headlineOf(const Diagnosis& diagnosis);

/// The verdict in whole sentences.
std::string sentenceOf(const Diagnosis& diagnosis);

/// One sentence for each effect whose known size is out of date, and for each cause that only known sizes
/// distinguish from another. Empty without either.
std::string staleSentence(const Diagnosis& diagnosis);

/// "0°, point 11, horizontal", with round and face unless they are 1.
std::string readingName(const ReadingDeviation& reading);

/// "+29.1″".
std::string secondsWithSign(double arcseconds);

/// Returns the reason for a missing diagnosis as a sentence, with its place in the session.
Problem problemOf(const NoModel& fault);
Problem problemOf(const DiagnosisFault& fault);

}  // namespace alidade

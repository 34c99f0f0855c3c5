#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// The name of the pattern in a gap without a cause: "vertical readings with azimuth".
std::string patternName(const GapShape& shape);

/// The verdict in a few words: "One cause: collimation".
std::string headlineOf(const Diagnosis& diagnosis);

/// The verdict in whole sentences.
std::string sentenceOf(const Diagnosis& diagnosis);

/// "0°, point 11, horizontal", with round and face unless they are 1.
std::string readingName(const ReadingDeviation& reading);
/// "+29.1″".
std::string secondsWithSign(double arcseconds);

}  // namespace alidade

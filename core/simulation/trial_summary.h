#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/simulation/trial_series.h"

namespace alidade {

/// So many of so many.
struct Tally {
  std::size_t hits = 0, count = 0;

  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++count;
  }
  Tally& operator+=(const Tally& part) {
    hits += part.hits;
    count += part.count;
    return *this;
  }
  bool operator==(const Tally&) const = default;
};

/// Effects that show by `from` up to below `to` σ of the readings.
struct DetectionBin {
  double from = 0, to = 0;
  Tally detected = {};  ///< a gap was found
  Tally named = {};     ///< and the truth named, alone or in a group
};

/// What became of the trials of one kind.
struct KindTally {
  Tally right = {}, named = {};
  Tally quiet = {};     ///< no gap was found
  Tally after = {};     ///< true Δd within Δd ± U with the causes found, whatever they are
  Tally measured = {};  ///< and as measured
};

struct TrialSummary {
  std::size_t count = 0;
  std::map<TrialClass, Tally> right = {};                                    ///< of the classes that occur
  std::map<std::string, std::map<std::string, std::size_t>> confusion = {};  ///< kind → answer → how often
  std::map<std::string, KindTally> kinds = {};
  Tally falseAlarms = {};  ///< a gap found where there is none
  std::vector<DetectionBin> detection = {};
  Tally covered = {};       ///< true Δd within Δd ± U after the cause is added
  Tally backToNoise = {};   ///< reduced χ² after the cause is what noise leaves
  Tally wrongWithout = {};  ///< a wrong cause blamed with the right one withheld
};

TrialSummary summarise(const std::vector<ScoredTrial>& trials);

}  // namespace alidade

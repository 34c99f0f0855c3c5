#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/simulation/trial_series.h"

namespace alidade {

/// A number of hits among a number of cases.
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

/// Effects whose visibility is at least `from` and less than `to`, in σ of the readings.
struct DetectionBin {
  double from = 0, to = 0;
  Tally detected = {};  ///< a gap was found
  Tally named = {};     ///< the truth is also named, alone or in a group
};

/// The results of the trials of one kind.
struct KindTally {
  Tally right = {}, named = {};
  Tally quiet = {};     ///< no gap was found
  Tally after = {};     ///< true Δd within Δd ± U with the causes found, whatever these are
  Tally measured = {};  ///< true Δd within Δd ± U for Δd, measured
};

struct TrialSummary {
  std::size_t count = 0;
  std::map<TrialClass, Tally> right = {};                                    ///< of the classes that occur
  std::map<std::string, std::map<std::string, std::size_t>> confusion = {};  ///< kind → answer → how often
  std::map<std::string, KindTally> kinds = {};
  Tally falseAlarms = {};  ///< a gap was found though the truth has no cause
  std::vector<DetectionBin> detection = {};
  Tally covered = {};       ///< true Δd within Δd ± U after the cause is added
  Tally backToNoise = {};   ///< reduced χ² with the cause added is at noise level
  Tally wrongWithout = {};  ///< a wrong cause is named, without the right one in the catalogue
};

TrialSummary summarise(const std::vector<ScoredTrial>& trials);

}  // namespace alidade

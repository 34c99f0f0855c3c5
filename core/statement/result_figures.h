#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/adjustment/result/arc_summary.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// A number of an arc. The table of the arcs, the certificate, JSON and CSV show every one of the list.
struct ArcFigure {
  const char* id;      ///< of its column, in CSV and in the certificate
  const char* key;     ///< in the JSON of an arc; null: in an object of several numbers
  const char* unit;    ///< "mm", "arcsec" or ""
  int decimals;        ///< for people; 0: a count, of which a part may be shared; negative: as many as its
                       ///< uncertainty needs
  const char* title;   ///< of its column; a phrase for `Phrase::of`
  const char* remark;  ///< explains the column; a phrase, may be empty
  const char* name;    ///< in the certificate; a phrase in which %1 is the centre, O1 or O2
  double (*value)(const ArcSummary& arc);            ///< not finite: not determined
  double (*sigma)(const ArcSummary& arc) = nullptr;  ///< standard uncertainty, in the same unit; null: none

  bool isOfEachRepeat = false;  ///< also shown of each of several arcs at one axis angle; has no uncertainty

  bool isCount() const { return decimals == 0; }
  /// The name for an arc at `axisDeg`: "x of the centre O1".
  std::string nameAt(int axisDeg) const;
};

std::span<const ArcFigure> arcFigures();

/// A length of the measured intersection beside Δd. Certificate, JSON and CSV show every one of the list.
struct MeasuredFigure {
  const char* id;            ///< also its key in JSON
  const char* name;          ///< a phrase for `Phrase::of`
  const char* distribution;  ///< in the certificate
  bool isNonNegative;
  std::optional<MeasuredLength> MeasuredIntersection::*length;
};

std::span<const MeasuredFigure> measuredFigures();

}  // namespace alidade

#pragma once

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade::test {

/// Two sessions of guideway G-1 share the trunnion tilt of instrument T-1. Alone, the second names
/// collimation. Their files are 5 and 6.
inline SeriesDiagnosis trunnionOfTwo() {
  SeriesDiagnosis series;
  series.verdict = DiagnosisVerdict::Ambiguous;
  for (const char* name : {"first", "second"}) {
    SeriesMember member;
    member.name = name;
    member.measuredOn = "2026-03-01";
    member.instrument = "T-1";
    member.guideway = "G-1";
    member.file = series.sessions.size() + 5;
    series.sessions.push_back(member);
  }
  series.sessions[1].alone = DiagnosisVerdict::SingleCause;
  series.sessions[1].causesAlone = {{.effect = "collimation"}};
  SharedCause cause;
  cause.cause = {.effect = "trunnion_tilt", .probability = 0.97, .parameters = {{"tilt", 12, 1.5, "arcsec"}}};
  cause.cause.indistinguishableFrom = {"plane_warp"};
  cause.owner = CauseOwner::Instrument;
  cause.serial = "T-1";
  cause.sessions = {0, 1};
  cause.visibleInOne = 2;
  cause.visibleTogether = 2.8;
  series.causes = {cause};
  series.advice = {{.what = SeriesAdvice::What::OtherInstrument,
                    .guideway = "G-1",
                    .separates = {"trunnion_tilt", "plane_warp"},
                    .bySigma = 4.5,
                    .sessions = 5}};
  return series;
}

}  // namespace alidade::test

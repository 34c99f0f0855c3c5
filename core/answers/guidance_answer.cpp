#include "core/answers/guidance_answer.h"

#include <utility>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/two_faces.h"
#include "core/diagnosis/diagnose.h"
#include "core/guidance/forecast.h"
#include "core/session/measurement.h"

namespace alidade {

Guidance guidanceOf(const Session& session, SightingProtocol protocol, std::optional<double> uncertainty) {
  Guidance guidance;
  guidance.progress = progressOf(session, protocol);
  guidance.protocol = std::move(protocol);
  guidance.uncertainty = uncertainty;
  guidance.expected.resize(guidance.progress.sightings.size());
  const Examined examined = examine(session);
  if (!examined.measurement) return guidance;
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  guidance.choice = followChoice(session, measurement, guidance.protocol, guidance.progress);
  if (uncertainty) guidance.ahead = sightingsAhead(measurement, guidance.protocol, *uncertainty);
  guidance.expected = forecast(measurement, fit, guidance.protocol, guidance.progress);
  const std::vector<Suspect> suspects =
      fit.arcs.empty() ? std::vector<Suspect>() : findSuspects(session, measurement, fit);
  const std::optional<TwoFaces> faces = compareFaces(measurement);
  guidance.allToRepeat =
      sightingsToRepeat({measurement, fit, faces ? &*faces : nullptr, suspects}, guidance.progress);
  std::optional<Diagnosis> diagnosis;
  if (fit.intersection)
    if (auto found = diagnose(measurement, fit)) diagnosis = *std::move(found);
  guidance.outlook =
      outlookOf(measurement, fit, diagnosis ? &*diagnosis : nullptr, guidance.protocol, guidance.progress);
  return guidance;
}

}  // namespace alidade

#include "core/answers/guidance_answer.h"

#include <utility>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/two_faces.h"
#include "core/diagnosis/diagnose.h"
#include "core/session/measurement.h"

namespace alidade {

Guidance guidanceOf(const Session& session, SightingProtocol protocol, std::optional<double> uncertainty) {
  const Examined examined = examine(session);
  if (!examined.measurement) return {guideAlong(std::move(protocol), session, nullptr), uncertainty};
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  const std::vector<Suspect> suspects =
      fit.arcs.empty() ? std::vector<Suspect>() : findSuspects(session, measurement, fit);
  const std::optional<TwoFaces> faces = compareFaces(measurement);
  const FittedSession fitted{measurement, fit, faces ? &*faces : nullptr, suspects};
  Guidance guidance{guideAlong(std::move(protocol), session, &fitted), uncertainty};
  std::optional<Diagnosis> found;
  if (fit.intersection)
    if (auto answer = diagnose(measurement, fit)) found = *std::move(answer);
  const Diagnosis* const diagnosis = found ? &*found : nullptr;
  if (uncertainty) guidance.ahead = sightingsAhead(measurement, guidance.protocol, *uncertainty, diagnosis);
  guidance.outlook = outlookOf(measurement, fit, diagnosis, guidance.protocol, guidance.progress);
  return guidance;
}

}  // namespace alidade

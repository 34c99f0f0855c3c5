#include "core/evaluation/guide.h"

#include <utility>

#include "core/evaluation/evaluation.h"
#include "core/guidance/forecast.h"

namespace alidade {

std::shared_ptr<const Guide> guideOf(const Evaluation& evaluation) {
  const Session& session = evaluation.session;
  if (session.protocol.empty()) return nullptr;
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  if (rows > mostSightings) return nullptr;
  Guide guide;
  auto protocol = protocolOf(session);
  if (!protocol || !*protocol) {
    if (!protocol) guide.problem = protocol.problem().text();
    return std::make_shared<const Guide>(std::move(guide));
  }
  guide.protocol = **std::move(protocol);
  guide.progress = progressOf(session, guide.protocol);
  guide.expected.resize(guide.progress.sightings.size());
  if (evaluation.examined.measurement) {
    const Measurement& measurement = *evaluation.examined.measurement;
    guide.choice = followChoice(session, measurement, guide.protocol, guide.progress);
    guide.expected = forecast(measurement, evaluation.fit, guide.protocol, guide.progress);
    guide.allToRepeat =
        sightingsToRepeat({measurement, evaluation.fit, evaluation.twoFaces ? &*evaluation.twoFaces : nullptr,
                           evaluation.suspects},
                          guide.progress);
  }
  return std::make_shared<const Guide>(std::move(guide));
}

}  // namespace alidade

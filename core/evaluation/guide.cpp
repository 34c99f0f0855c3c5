#include "core/evaluation/guide.h"

#include <utility>

#include "core/evaluation/evaluation.h"
#include "core/guidance/forecast.h"

namespace alidade {

Guide guideAlong(SightingProtocol protocol, const Session& session, const FittedSession* fitted) {
  Guide guide;
  guide.progress = progressOf(session, protocol);
  guide.expected.resize(guide.progress.sightings.size());
  if (fitted) {
    guide.choice = followChoice(session, fitted->measurement, protocol, guide.progress);
    guide.expected = forecast(fitted->measurement, fitted->fit, protocol, guide.progress);
    guide.allToRepeat = sightingsToRepeat(*fitted, guide.progress);
  }
  guide.protocol = std::move(protocol);
  return guide;
}

std::shared_ptr<const Guide> guideOf(const Evaluation& evaluation) {
  const Session& session = evaluation.session;
  if (session.protocol.empty()) return nullptr;
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  if (rows > mostSightings) return nullptr;
  auto protocol = protocolOf(session);
  if (!protocol || !*protocol) {
    Guide guide;
    if (!protocol) guide.problem = protocol.problem().text();
    return std::make_shared<const Guide>(std::move(guide));
  }
  const auto along = [&](const FittedSession* fitted) {
    return std::make_shared<const Guide>(guideAlong(**std::move(protocol), session, fitted));
  };
  if (!evaluation.examined.measurement) return along(nullptr);
  const FittedSession fitted{*evaluation.examined.measurement, evaluation.fit,
                             evaluation.twoFaces ? &*evaluation.twoFaces : nullptr, evaluation.suspects};
  return along(&fitted);
}

}  // namespace alidade

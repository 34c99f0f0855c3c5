#include "core/answers/fit_answer.h"

#include <algorithm>
#include <utility>

#include "core/answers/beforehand.h"
#include "core/base/sha256.h"
#include "core/session/hindrance.h"

namespace alidade {

namespace {

std::optional<Problem> whyNone(const Evaluation& evaluation) {
  if (auto problem = firstHindrance(evaluation.session, evaluation.examined.problems)) return problem;
  if (evaluation.failure) return Problem{sentencesOf(*evaluation.failure)};
  if (evaluation.searchFailure) return Problem{sentencesOf(*evaluation.searchFailure)};
  return absence(evaluation.examined.measurement.value(), evaluation.fit.arcs.size(),
                 evaluation.fit.findings);
}

}  // namespace

Result<FitAnswer> fitAnswerOf(const Gap& gap, const std::string& name, std::string_view file) {
  const Evaluation& evaluation = *gap.evaluation;
  if (auto problem = whyNone(evaluation)) return *std::move(problem);
  const Measurement& measurement = *evaluation.examined.measurement;
  FitAnswer answer{name, measurement, evaluation.fit, evaluation.suspects};
  if (!evaluation.isSearched) answer.suspects = findSuspects(evaluation.session, measurement, evaluation.fit);
  answer.diagnosis = gap.diagnosis;
  answer.arrivals = arrivalsOf(evaluation.session);
  answer.digest = sha256(file);
  answer.dependences =
      gap.dependences ? *gap.dependences : dependencesOf(measurement, answer.fit, gap.found());
  return answer;
}

std::vector<Arrival> arrivalsOf(const Session& session) {
  std::vector<Arrival> arrivals;
  for (std::size_t position = 0; position < session.positions.size(); ++position) {
    const std::vector<Reading>& rows = session.positions[position].readings;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const Reading& reading = rows[row];
      if (!reading.takenAt.empty() || !reading.returnCode.empty() || !reading.instrumentSerial.empty())
        arrivals.push_back({position, row, reading.takenAt, reading.returnCode, reading.instrumentSerial});
    }
  }
  return arrivals;
}

const Arrival* arrivalAt(const std::vector<Arrival>& arrivals, std::size_t position, std::size_t row) {
  const auto placeOf = [](const Arrival& arrival) { return std::pair(arrival.position, arrival.row); };
  const auto found = std::ranges::lower_bound(arrivals, std::pair(position, row), {}, placeOf);
  return found != arrivals.end() && placeOf(*found) == std::pair(position, row) ? &*found : nullptr;
}

}  // namespace alidade

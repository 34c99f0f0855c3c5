// example_diagnose FILE: what causes the gap between the model and the readings of a saved session.

#include <cstdio>

#include "core/diagnosis/diagnose.h"
#include "core/session/session_file.h"
#include "core/wording/diagnosis_sentence.h"

int main(int argc, char** argv) {
  using namespace alidade;
  if (argc != 2) return 2;

  const Result<Session> session = loadSession(argv[1]);
  if (!session) {
    std::fprintf(stderr, "%s\n", session.problem().text().c_str());
    return 1;
  }
  const Examined examined = examine(*session);
  if (!examined.measurement) return 1;

  const Result<Diagnosis, DiagnosisFault> diagnosis = diagnose(*examined.measurement);
  if (!diagnosis) {
    std::fprintf(stderr, "%s\n", problemOf(diagnosis.problem()).text().c_str());
    return 1;
  }
  std::printf("%s\n", nameOf(diagnosis->verdict).data());
  for (const Cause& cause : diagnosis->causes)
    for (const CauseParameter& parameter : cause.parameters)
      std::printf("%s: %s %.2f ± %.2f %s, with probability %.3f\n", cause.effect.c_str(),
                  parameter.name.c_str(), parameter.value, parameter.sigma, parameter.unit.c_str(),
                  cause.probability);
  std::printf("residuals %.2f″, with the causes in the model %.2f″\n", diagnosis->gap.rms,
              diagnosis->after.rms);
  if (diagnosis->afterwards)
    std::printf("intersection %.4f ± %.4f mm\n", diagnosis->afterwards->value,
                diagnosis->afterwards->expanded);
}

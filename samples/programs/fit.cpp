// example_fit FILE: the intersection of a saved session.

#include <cstdio>

#include "core/adjustment/result/session_fit.h"
#include "core/session/session_file.h"

int main(int argc, char** argv) {
  using namespace alidade;
  if (argc != 2) return 2;

  const Result<Session> session = loadSession(argv[1]);
  if (!session) {
    std::fprintf(stderr, "%s\n", session.problem().text().c_str());
    return 1;
  }
  // A session holds texts as they were typed; what they mean is a measurement.
  const Examined examined = examine(*session);
  for (const Problem& problem : examined.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
  if (!examined.measurement) return 1;

  const SessionFit fit = fitSession(*examined.measurement);
  for (const ArcFit& arc : fit.arcs)
    std::printf("%d°: centre (%.4f, %.4f) mm, radius %.4f mm\n", arc.axisDeg, arc.circle.x, arc.circle.y,
                arc.circle.radius);
  if (!fit.intersection) return 1;
  std::printf("intersection %.4f ± %.4f mm\n", fit.intersection->value, fit.intersection->expanded);
}

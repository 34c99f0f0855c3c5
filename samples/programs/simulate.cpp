// example_simulate: what a theodolite whose line of sight is 25″ off reads on a guideway, as a session file.

#include <cstdio>

#include "core/session/session_file.h"
#include "core/simulation/simulate.h"

int main() {
  using namespace alidade;

  Truth truth;
  truth.intersection = 0.4;  // mm: the arc centre lies this far off the rotation axis
  truth.axisHeight = -1.2;
  truth.effects = {{.term = ErrorTerm::Collimation, .value = 25}};  // in the catalogue's unit: arcseconds

  Protocol protocol;
  protocol.points = 9;
  protocol.step = Angle::fromDegrees(20);
  protocol.faces = FacePlan::BothAtEachPlace;

  const Result<Session> session = simulate(protocol, truth, 42);
  if (!session) {
    std::fprintf(stderr, "%s\n", session.problem().text().c_str());
    return 1;
  }
  std::fputs(writeSession(*session).c_str(), stdout);
}

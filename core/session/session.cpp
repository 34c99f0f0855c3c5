#include "core/session/session.h"

namespace alidade {

Session blankSession() {
  Session session;
  session.instrument.sigmaHorizontalArcsec = "2";
  session.instrument.sigmaVerticalArcsec = "2";
  session.instrument.sigmaZeroArcsec = "2";
  session.geometry.verticalCircle = "zenith";
  session.acceptance.coverage = "0.95";
  session.model.verticalAngle = "exact";
  for (const char* axis : {"0", "180"}) {
    Position position;
    position.axisDeg = axis;
    session.positions.push_back(position);
  }
  return session;
}

}  // namespace alidade

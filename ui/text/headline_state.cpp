#include "ui/text/headline_state.h"

namespace alidade::ui {

State stateOf(const Headline& headline) {
  if (!headline.decided) return State::Quiet;
  switch (*headline.decided) {
    case Verdict::Accept:
      return State::Good;
    case Verdict::Reject:
      return State::Bad;
    case Verdict::Undecided:
      break;
  }
  return State::Open;
}

}  // namespace alidade::ui

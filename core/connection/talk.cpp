#include "core/connection/talk.h"

#include <algorithm>

namespace alidade {

TalkStep InstrumentTalk::begin(Milliseconds now) {
  TalkStep step;
  onBegin(now, step);
  return step;
}

TalkStep InstrumentTalk::receive(std::string_view bytes, Milliseconds now) {
  TalkStep step;
  std::vector<std::string> lines;
  m_lines.take(bytes, now, lines, step.remarks);
  for (const std::string& line : lines) {
    step.lines.push_back({false, line});
    onLine(line, now, step);
  }
  return step;
}

TalkStep InstrumentTalk::take(Milliseconds now) {
  TalkStep step;
  onTake(now, step);
  return step;
}

TalkStep InstrumentTalk::tick(Milliseconds now) {
  TalkStep step;
  m_lines.tick(now, step.remarks);
  if (!step.remarks.empty()) onLineLost(now, step);
  onTick(now, step);
  return step;
}

std::optional<Milliseconds> InstrumentTalk::wakeAt() const {
  const auto line = m_lines.wakeAt(), own = onWakeAt();
  if (line && own) return std::min(*line, *own);
  return line ? line : own;
}

void InstrumentTalk::send(const std::string& line, TalkStep& step) {
  step.toSend += line + "\r\n";
  step.lines.push_back({true, line});
}

}  // namespace alidade
